// SPDX-License-Identifier: MIT
// Trajectories as text. Timestamps have six decimals, poses nine significant digits: the same run
// gives the same bytes.
#pragma once

#include <filesystem>
#include <string>

#include "engine/base/result.h"
#include "engine/geometry/trajectory.h"

namespace svoscope {

/// "timestamp tx ty tz qx qy qz qw" (s, m), without line end.
std::string tumLine(const StampedPose& pose);

/// Comment that heads a TUM file.
constexpr const char* kTumHeader = "# timestamp tx ty tz qx qy qz qw (camera to world)";

/// Each writes the whole file or fails with an output error naming it.
Status writeTumTrajectory(const std::filesystem::path& file, const Trajectory& poses);
/// CSV: timestamp [ns], p x y z [m], q w x y z.
Status writeEurocTrajectory(const std::filesystem::path& file, const Trajectory& poses);
/// Twelve numbers a row, the upper 3x4 of the pose matrix; timestamps are lost.
Status writeKittiTrajectory(const std::filesystem::path& file, const Trajectory& poses);

}  // namespace svoscope
