// SPDX-License-Identifier: MIT
// Calibration files of other tools, read as they are: Kalibr, ASL, ROS camera_info, OpenCV,
// ORB-SLAM2/3, SVO (vikit), SVO Pro, VINS, basalt, DSO and COLMAP.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/geometry/camera.h"
#include "engine/geometry/se3.h"

namespace svoscope {

struct Calibration {
  Camera camera;
  SE3 T_body_cam;                  ///< pose of the camera in the body (IMU), m
  bool has_body = false;           ///< the file gives T_body_cam
  std::string format;              ///< which tool's layout it was: "Kalibr camchain"
  std::vector<std::string> notes;  ///< what was converted or assumed, one line each
};

/// Size of the images a calibration is for, px; 0: unknown. Some layouts leave it out.
struct ImageSize {
  int width = 0, height = 0;
};

/// Reads a calibration of any known layout; the layout is recognised by its keys. Input errors name
/// file, key and remedy: an unknown layout, a camera model that is no pinhole, missing or malformed
/// values, values that fail Camera::check(), intrinsics that cannot be pixels.
Result<Calibration> readCalibration(const std::filesystem::path& file, ImageSize images = {});

/// Only the pose of the camera in the body: T_BS (ASL), T_cam_imu (Kalibr), T_B_C (SVO Pro),
/// T_imu_cam (basalt). Input error if the file has none.
Result<SE3> readExtrinsics(const std::filesystem::path& file);

/// Why the intrinsics cannot belong to images of this size in pixels, with the pixels they would be
/// if they were relative to the image: a focal length under a twentieth of the width, or a
/// principal point outside the image.
Status plausibleIntrinsics(const Pinhole& pinhole, const std::string& file);

}  // namespace svoscope
