// SPDX-License-Identifier: MIT
// Ground truth held against the estimate while a run goes on: alignment, errors, and the ground
// truth drawn in the map's frame.
#pragma once

#include <string>
#include <vector>

#include "engine/eval/alignment.h"
#include "engine/snapshot/snapshot.h"

namespace svoscope::ui {

/// "none", "SE(3)", "Sim(3)": for people.
const char* alignmentLabel(Alignment alignment);

struct TruthState {
  bool valid = false;   ///< at least three poses matched
  std::string problem;  ///< why there is no result, if not
  Alignment mode = Alignment::sim3;
  int map_id = -1;            ///< the map with most poses, which all of this is about
  int matched = 0;            ///< poses with ground truth
  double scale = 1;           ///< metres per map unit
  Mat3 R = Mat3::Identity();  ///< ground truth <- map
  Vec3 t = Vec3::Zero();
  double ate_rmse = 0, ate_mean = 0, ate_median = 0, ate_max = 0;  ///< m
  double rpe_trans = 0, rpe_rot = 0;  ///< over one second: m and radians, RMSE
  int rpe_pairs = 0;
  std::vector<float> error;   ///< per record, m; NaN where unknown
  std::vector<Vec3f> path;    ///< ground truth positions so far, in the map's frame
  std::uint64_t version = 0;  ///< changes with the content
};

class Truth {
 public:
  /// Recomputes if enough frames were added since the last time (`settled`: any), or the mode
  /// changed.
  void update(const std::vector<FrameRecord>& records, const Trajectory& truth, Alignment mode,
              int generation, bool settled);
  const TruthState& state() const { return state_; }

 private:
  TruthState state_;
  std::size_t done_ = 0;
  int generation_ = -1;
};

/// Without the cache, for tests.
TruthState alignTruth(const std::vector<FrameRecord>& records, const Trajectory& truth,
                      Alignment mode);

}  // namespace svoscope::ui
