// SPDX-License-Identifier: MIT
// The two trajectories of an evaluation, with the conventions the user names applied.
#pragma once

#include <string>
#include <vector>

#include "engine/eval/trajectory_file.h"

namespace svoscope {

struct EvalConventions {
  std::string extrinsics;  ///< calibration that says where the camera sits on the body
  std::string quaternion;  ///< "xyzw", "wxyz", "gt-wxyz", "est-wxyz"
  bool invert = false;     ///< the estimate holds poses of the world in the camera
  bool mirror = false;     ///< the estimate is of a left-handed world
};

/// A trajectory file, or a sequence, whose ground truth is that of its camera. With `extrinsics`
/// poses of the body become poses of the camera. Prints warnings, also that an EuRoC ground truth
/// without extrinsics is of the body.
Result<TrajectoryFile> loadGroundTruth(const std::string& path, const EvalConventions& conventions);

/// An estimate, as the conventions have it.
Result<TrajectoryFile> loadEstimate(const std::string& path, const EvalConventions& conventions);

}  // namespace svoscope
