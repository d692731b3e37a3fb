// SPDX-License-Identifier: MIT
// Mistaken conventions that look like bad trajectories: clocks that differ, quaternions that begin
// with w, poses of the world in the camera, left-handed worlds. Tried after an evaluation; one that
// fits far better is reported, never applied unasked.
#pragma once

#include <string>
#include <vector>

#include "engine/eval/evaluate.h"

namespace svoscope {

struct ConventionDoubt {
  std::string text;    ///< what would fit better, with both figures
  std::string option;  ///< of `svoscope eval` that applies it
};

/// Doubts about an evaluation: an error of positions or rotations that falls to under a third by
/// another convention. `truth_is_tum` and `estimate_is_tum`: quaternions without a fixed order.
std::vector<ConventionDoubt> conventionDoubts(const Trajectory& ground_truth,
                                              const Trajectory& estimate, const EvalResult& result,
                                              bool truth_is_tum, bool estimate_is_tum);

/// The offset that would let both begin at the same time, if they do not overlap in time; for the
/// error of an evaluation without matches. Empty if they overlap.
std::string clockDoubt(const Trajectory& ground_truth, const Trajectory& estimate);

/// Poses of the world in the camera turned into poses of the camera in the world, and back.
Trajectory invertedPoses(const Trajectory& poses);
/// The same in a world with its x axis reversed.
Trajectory mirroredPoses(const Trajectory& poses);
/// Quaternions read as x y z w that were written as w x y z.
Trajectory reorderedQuaternions(const Trajectory& poses);

}  // namespace svoscope
