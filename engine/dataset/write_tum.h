// SPDX-License-Identifier: MIT
// Writes a sequence as a TUM RGB-D folder.
#pragma once

#include <filesystem>
#include <functional>

#include "engine/dataset/sequence.h"

namespace svoscope {

/// Called after each frame; false stops the writing.
using WriteProgress = std::function<bool(int done, int total)>;

/// Writes rgb/*.png, rgb.txt and camera.yaml, groundtruth.txt if there is ground truth, depth/*.png
/// (16 bit, metres x 5000; beyond 13.1 m unknown, 0) and depth.txt if there is depth. Lists hold
/// the frames written so far when stopped. Input error if a frame cannot be read, output error if a
/// file cannot be written.
Status writeTumSequence(Sequence& sequence, const std::filesystem::path& out,
                        const WriteProgress& progress);

}  // namespace svoscope
