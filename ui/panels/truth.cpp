// SPDX-License-Identifier: MIT
#include "ui/panels/truth.h"

#include <algorithm>
#include <cmath>

namespace svoscope::ui {

namespace {

constexpr double kMaxDt = 0.02;  // s, the usual association limit

struct Pair {
  std::size_t record = 0;
  const StampedPose* truth = nullptr;
};

const StampedPose* nearest(const Trajectory& truth, double time) {
  auto it = std::lower_bound(truth.begin(), truth.end(), time,
                             [](const StampedPose& p, double t) { return p.timestamp < t; });
  if (it == truth.end() || (it != truth.begin() &&
                            time - (it - 1)->timestamp < it->timestamp - time)) {
    if (it == truth.begin()) return nullptr;
    --it;
  }
  return std::abs(it->timestamp - time) <= kMaxDt ? &*it : nullptr;
}

std::vector<Pair> associate(const std::vector<FrameRecord>& records, const Trajectory& truth) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (!records[i].pose_good || !records[i].T_world_cam.finite()) continue;
    if (const StampedPose* p = nearest(truth, records[i].timestamp)) pairs.push_back({i, p});
  }
  return pairs;
}

void align(TruthState& s, const std::vector<Pair>& pairs, const std::vector<FrameRecord>& records) {
  Eigen::Matrix3Xd from(3, pairs.size()), to(3, pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    from.col(static_cast<Eigen::Index>(i)) = records[pairs[i].record].T_world_cam.translation();
    to.col(static_cast<Eigen::Index>(i)) = pairs[i].truth->T_world_cam.translation();
  }
  const Vec3 mean = from.rowwise().mean();
  if ((from.colwise() - mean).norm() < 1e-9) return;  // no motion: nothing to align to
  const Mat4 T = Eigen::umeyama(from, to, s.mode == AlignMode::sim3);
  if (!T.allFinite()) return;
  const Mat3 A = T.topLeftCorner<3, 3>();
  s.scale = s.mode == AlignMode::sim3 ? std::cbrt(std::max(1e-12, A.determinant())) : 1;
  s.R = A / s.scale;
  s.t = T.topRightCorner<3, 1>();
}

void measure(TruthState& s, const std::vector<Pair>& pairs,
             const std::vector<FrameRecord>& records) {
  std::vector<double> errors;
  double sum = 0, squares = 0;
  for (const Pair& p : pairs) {
    const Vec3 mapped = s.scale * (s.R * records[p.record].T_world_cam.translation()) + s.t;
    const double e = (mapped - p.truth->T_world_cam.translation()).norm();
    s.error[p.record] = static_cast<float>(e);
    errors.push_back(e);
    sum += e;
    squares += e * e;
  }
  const auto n = static_cast<double>(errors.size());
  std::sort(errors.begin(), errors.end());
  s.ate_rmse = std::sqrt(squares / n);
  s.ate_mean = sum / n;
  s.ate_median = errors[errors.size() / 2];
  s.ate_max = errors.back();
}

// Motion over one second, estimate against ground truth.
void measureRelative(TruthState& s, const std::vector<Pair>& pairs,
                     const std::vector<FrameRecord>& records) {
  double trans = 0, rot = 0;
  std::size_t j = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double until = pairs[i].truth->timestamp + 1.0;
    while (j < pairs.size() && pairs[j].truth->timestamp < until - kMaxDt) ++j;
    if (j >= pairs.size()) break;
    if (pairs[j].truth->timestamp > until + kMaxDt) continue;
    const SE3 est = records[pairs[i].record].T_world_cam.inverse() * records[pairs[j].record].T_world_cam;
    const SE3 ref = pairs[i].truth->T_world_cam.inverse() * pairs[j].truth->T_world_cam;
    const SE3 scaled(est.quaternion(), s.scale * est.translation());
    const SE3 d = ref.inverse() * scaled;
    trans += d.translation().squaredNorm();
    rot += so3Log(d.quaternion()).squaredNorm();
    ++s.rpe_pairs;
  }
  if (s.rpe_pairs == 0) return;
  s.rpe_trans = std::sqrt(trans / s.rpe_pairs);
  s.rpe_rot = std::sqrt(rot / s.rpe_pairs);
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

const char* alignModeName(AlignMode mode) {
  switch (mode) {
    case AlignMode::none: return "none";
    case AlignMode::se3: return "SE(3)";
    case AlignMode::sim3: return "Sim(3)";
  }
  return "";
}

TruthState alignTruth(const std::vector<FrameRecord>& records, const Trajectory& truth,
                      AlignMode mode) {
  TruthState s;
  s.mode = mode;
  s.error.assign(records.size(), NAN);
  if (truth.empty() || records.empty()) return s;
  const auto pairs = associate(records, truth);
  s.matched = static_cast<int>(pairs.size());
  if (pairs.size() < 3) return s;
  if (mode != AlignMode::none) align(s, pairs, records);
  s.valid = true;
  measure(s, pairs, records);
  measureRelative(s, pairs, records);
  bringToMap(s, truth, records.back().timestamp);
  return s;
}

void Truth::update(const std::vector<FrameRecord>& records, const Trajectory& truth, AlignMode mode,
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
