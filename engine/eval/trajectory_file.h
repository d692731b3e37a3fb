// SPDX-License-Identifier: MIT
// Reads trajectories in the three text formats in use and tells which one it was.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/eval/trajectory.h"

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

/// Reads a trajectory; the format is recognised by the first row. Input errors name file and line:
/// unreadable or empty file, wrong number of columns, text or NaN where a number is expected,
/// a quaternion or matrix that is no rotation, timestamps that go back, or that repeat in more
/// than one row of ten (written with too few digits). Published ground truths do repeat a timestamp
/// here and there: the first of such rows counts, with a warning.
Result<TrajectoryFile> loadTrajectory(const std::filesystem::path& file);

}  // namespace svoscope
