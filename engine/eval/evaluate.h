// SPDX-License-Identifier: MIT
// Absolute trajectory error and relative pose error of an estimate (docs/evaluation.md).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/eval/alignment.h"
#include "engine/eval/delta.h"
#include "engine/geometry/trajectory.h"

namespace svoscope {

struct EvalOptions {
  Alignment alignment = Alignment::sim3;  ///< sim3: a single camera does not know the scale
  double max_dt = 0.02;                   ///< association limit, s
  double time_offset = 0;                 ///< s, added to the timestamps of the estimate
  bool by_row = false;                    ///< match row i with row i (files without timestamps)
  int align_first = 0;                    ///< align on the first so many matches; 0: on all
  Delta delta;                            ///< interval of the relative error
  bool all_pairs = false;                 ///< relative error over overlapping pairs
  bool orientations = true;               ///< both know them; without, no relative error
};

/// Statistics of distances, metres.
struct ErrorStatistics {
  double rmse = 0, mean = 0, median = 0, max = 0, stddev = 0, min = 0;
};
/// All zero if `values` is empty; the median of an even number is the mean of the middle two.
ErrorStatistics statisticsOf(std::vector<double> values);

struct RelativeError {
  double trans_rmse_m = 0;
  double rot_rmse_rad = 0;
  int pairs = 0;
};

/// One matched pose.
struct PoseError {
  double timestamp = 0;              ///< s, of the estimate, on the clock of the ground truth
  double error_m = 0;                ///< distance of the aligned position from the ground truth
  Vec3 position_gt = Vec3::Zero();   ///< ground truth
  Vec3 position_est = Vec3::Zero();  ///< estimate after alignment, in the ground truth's world
};

struct EvalResult {
  EvalOptions options;               ///< as used: alignment mode, association limit, interval
  int aligned_on = 0;                ///< matches the alignment was computed from; 0 without one
  ErrorStatistics ate;               ///< of the aligned positions
  std::optional<RelativeError> rpe;  ///< empty: rpe_note says why
  std::string rpe_note;
  double scale = 1;                 ///< ground truth metres per unit of the estimate
  int matched = 0;                  ///< pose pairs
  int poses_gt = 0, poses_est = 0;  ///< in the trajectories given
  /// Share of the ground truth's time between matches that follow one another within a second (or
  /// twice its own step, if that is more); by rows, share of its rows.
  double coverage = 0;
  bool straight = false;          ///< all on a line: the rotation about it is not determined
  Sim3 T_gt_est;                  ///< world of the estimate to world of the ground truth
  std::vector<PoseError> errors;  ///< one per match, by time
};

/// Associates, aligns and compares. Both trajectories must be sorted by time. Input error if
/// nothing matches or the alignment is not determined (see alignPoints).
Result<EvalResult> evaluate(const Trajectory& ground_truth, const Trajectory& estimate,
                            const EvalOptions& options = {});

}  // namespace svoscope
