// SPDX-License-Identifier: MIT
// One loader per layout; openSequence() picks. All report input errors that name the file that is
// missing or damaged and the layout expected.
#pragma once

#include <filesystem>
#include <memory>

#include "engine/dataset/sequence.h"

namespace svoscope {

using OpenedSequence = Result<std::unique_ptr<Sequence>>;

/// rgb.txt, the images it lists, camera.yaml (or a folder name with freiburg1/2/3 or fr1/2/3);
/// optional groundtruth.txt and depth.txt (16-bit PNG, metres x 5000; each belongs to the nearest
/// image within 0.02 s).
OpenedSequence openTumSequence(const std::filesystem::path& folder);

/// The folder that contains mav0, or mav0: cam0/data.csv, cam0/data/, cam0/sensor.yaml; optional
/// state_groundtruth_estimate0/data.csv or mocap0/data.csv, poses of the body turned into poses of
/// the camera: T_world_cam = T_world_body * T_body_cam with T_body_cam = T_BS of cam0.
OpenedSequence openEurocSequence(const std::filesystem::path& folder);

/// A folder like sequences/00: image_0/, calib.txt with P0, times.txt; optional poses.txt there or
/// ../../poses/00.txt (poses of the left grey camera).
OpenedSequence openKittiSequence(const std::filesystem::path& folder);

/// Images in natural order and camera.yaml, whose rate_hz (default 30) gives the time stamps;
/// optional groundtruth.txt in TUM format.
OpenedSequence openImageFolder(const std::filesystem::path& folder);

/// A video with NAME.yaml or camera.yaml beside it. Reading forward is fast, backward reopens.
OpenedSequence openVideoSequence(const std::filesystem::path& file);

}  // namespace svoscope
