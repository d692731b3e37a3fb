// SPDX-License-Identifier: MIT
// Reads trajectories in the text formats in use and tells which one it was. The one reader of every
// command and of every sequence's ground truth.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/stamps.h"
#include "engine/geometry/trajectory.h"

namespace svoscope {

enum class TrajectoryFormat {
  tum,    ///< timestamp tx ty tz [qx qy qz qw [covariances ...]]
  euroc,  ///< CSV: timestamp in ns, p x y z [, q w x y z], further columns ignored
  kitti,  ///< rows of the upper 3x4 of a pose matrix, no timestamps
};
const char* trajectoryFormatName(TrajectoryFormat format);

struct TrajectoryFile {
  Trajectory poses;  ///< as in the file, by time; KITTI rows have their row number as timestamp
  TrajectoryFormat format = TrajectoryFormat::tum;
  bool positions_only = false;        ///< no orientation is known: all of them are the identity
  int skipped_rows = 0;               ///< without a finite pose
  std::vector<std::string> warnings;  ///< what was passed over or converted, one line each
};

/// What the trajectory is for decides how much damage it may have.
enum class TrajectoryUse {
  /// Recorders of ground truth leave gaps: rows that are not finite are passed over, rows out of
  /// order sorted, up to one in ten may repeat the timestamp of another; each with a warning.
  ground_truth,
  estimate,  ///< none of this: an estimate has one good pose for a time, in order
};

/// How the quaternion of a TUM row is ordered; files say nothing about it.
enum class QuaternionOrder { xyzw, wxyz };

struct TrajectoryReading {
  TrajectoryUse use = TrajectoryUse::ground_truth;
  QuaternionOrder quaternion = QuaternionOrder::xyzw;  ///< of TUM rows
};

/// Reads a trajectory; the format is recognised by the first row, the unit of its timestamps by
/// their size and steps (base/stamps.h). Input errors name file and line: unreadable or empty file,
/// wrong number of columns, text where a number is expected, a quaternion or matrix that is no
/// rotation, and what `use` does not allow. Of rows with the same timestamp the first counts.
Result<TrajectoryFile> loadTrajectory(const std::filesystem::path& file,
                                      const TrajectoryReading& reading = {});

}  // namespace svoscope
