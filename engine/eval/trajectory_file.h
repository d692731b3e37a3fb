// SPDX-License-Identifier: MIT
// Reads trajectories in the three text formats in use and tells which one it was.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/geometry/trajectory.h"

namespace svoscope {

enum class TrajectoryFormat {
  tum,    ///< timestamp tx ty tz qx qy qz qw; seconds (nanoseconds if above 1e14)
  euroc,  ///< CSV: timestamp in ns, p x y z, q w x y z, further columns ignored
  kitti,  ///< rows of the upper 3x4 of a pose matrix, no timestamps
};
const char* trajectoryFormatName(TrajectoryFormat format);

struct TrajectoryFile {
  Trajectory poses;  ///< as in the file; KITTI rows have their row number as timestamp
  TrajectoryFormat format = TrajectoryFormat::tum;
  std::vector<std::string> warnings;  ///< what was passed over, one line each
};

/// What becomes of rows that repeat the timestamp of the one above.
enum class RepeatedStamps {
  warn,    ///< up to one row in ten is passed over with a warning: ground truths do so now and then
  reject,  ///< none: an estimate has one pose for a time
};

/// Reads a trajectory; the format is recognised by the first row. Input errors name file and line:
/// unreadable or empty file, wrong number of columns, text or NaN where a number is expected,
/// a quaternion or matrix that is no rotation, timestamps that go back, or that repeat where
/// `repeats` does not allow it. Of rows with the same timestamp the first counts.
Result<TrajectoryFile> loadTrajectory(const std::filesystem::path& file,
                                      RepeatedStamps repeats = RepeatedStamps::warn);

}  // namespace svoscope
