// SPDX-License-Identifier: MIT
// Readers of the three trajectory formats in use. Poses are returned as they stand in the file;
// which frame they belong to (camera or body) is the caller's knowledge.
#pragma once

#include <filesystem>
#include <vector>

#include "engine/base/result.h"
#include "engine/geometry/trajectory.h"

namespace svoscope {

/// "timestamp tx ty tz qx qy qz qw" (s, m), separated by blanks or commas. Sorted by time on
/// return. Input error with file and line: missing file or fields, not finite, quaternion of norm
/// zero, no pose at all.
Result<Trajectory> readTumTrajectory(const std::filesystem::path& file);

/// ASL ground truth "timestamp [ns], px, py, pz, qw, qx, qy, qz, ..." (m). Poses of the body
/// (IMU) frame: multiply by the T_BS of the camera from the right. Errors as above.
Result<Trajectory> readEurocTrajectory(const std::filesystem::path& file);

/// KITTI odometry: one row-major 3x4 matrix [R t] (m) a line, line i for frame i. Errors as
/// above, and a matrix whose left part is not a rotation.
Result<std::vector<SE3>> readKittiPoses(const std::filesystem::path& file);

}  // namespace svoscope
