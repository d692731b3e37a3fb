// SPDX-License-Identifier: MIT
#include "ui/model/truth.h"

#include <algorithm>
#include <cmath>

#include "engine/eval/estimate.h"
#include "engine/eval/evaluate.h"

namespace svoscope::ui {

namespace {

constexpr double kMaxDt = 0.02;  // s, the usual association limit

void takeOver(TruthState& s, const EvalResult& result, const std::vector<FrameRecord>& records) {
  s.valid = true;
  s.matched = result.matched;
  s.scale = result.scale;
  s.R = result.T_gt_est.T.rotation();
  s.t = result.T_gt_est.T.translation();
  s.ate_rmse = result.ate.rmse;
  s.ate_mean = result.ate.mean;
  s.ate_median = result.ate.median;
  s.ate_max = result.ate.max;
  if (result.rpe) {
    s.rpe_trans = result.rpe->trans_rmse_m;
    s.rpe_rot = result.rpe->rot_rmse_rad;
    s.rpe_pairs = result.rpe->pairs;
  }
  std::size_t i = 0;  // both are sorted by time
  for (const PoseError& e : result.errors) {
    while (i < records.size() && records[i].timestamp < e.timestamp) ++i;
    if (i < records.size()) s.error[i] = static_cast<float>(e.error_m);
  }
}

void bringToMap(TruthState& s, const Trajectory& truth, double until) {
  const std::size_t step = std::max<std::size_t>(1, truth.size() / 4000);
  for (std::size_t i = 0; i < truth.size(); i += step) {
    if (truth[i].timestamp > until + kMaxDt) break;
    const Vec3 p = s.R.transpose() * (truth[i].T_world_cam.translation() - s.t) / s.scale;
    s.path.push_back(p.cast<float>());
  }
}

}  // namespace

const char* alignmentLabel(Alignment alignment) {
  switch (alignment) {
    case Alignment::none:
      return "none";
    case Alignment::se3:
      return "SE(3)";
    case Alignment::sim3:
      return "Sim(3)";
  }
  return "";
}

TruthState alignTruth(const std::vector<FrameRecord>& records, const Trajectory& truth,
                      Alignment mode) {
  TruthState s;
  s.mode = mode;
  s.error.assign(records.size(), NAN);
  if (truth.empty() || records.empty()) return s;
  const Trajectory estimate = estimateOf(records);
  if (estimate.empty()) {
    s.problem = "no frame has a pose yet";
    return s;
  }
  EvalOptions options;
  options.alignment = mode;
  options.max_dt = kMaxDt;
  const auto result = evaluate(truth, estimate, options);
  if (!result.ok()) {
    s.problem = result.error().what;
    return s;
  }
  if (result.value().matched < 3) return s;
  s.map_id = mainMap(records);
  takeOver(s, result.value(), records);
  bringToMap(s, truth, records.back().timestamp);
  return s;
}

void Truth::update(const std::vector<FrameRecord>& records, const Trajectory& truth, Alignment mode,
                   int generation, bool settled) {
  const bool other = generation != generation_ || mode != state_.mode || records.size() < done_;
  const std::size_t added = other ? records.size() : records.size() - done_;
  if (!other && (added == 0 || (!settled && added < 10))) return;
  const std::uint64_t version = state_.version + 1;
  state_ = alignTruth(records, truth, mode);
  state_.version = version;
  done_ = records.size();
  generation_ = generation;
}

}  // namespace svoscope::ui
