// SPDX-License-Identifier: MIT
#include "engine/eval/evaluate.h"

#include <algorithm>
#include <cmath>

#include "engine/base/stamps.h"
#include "engine/eval/association.h"

namespace svoscope {

namespace {

std::optional<RelativeError> relativeError(const Trajectory& gt, const Trajectory& est,
                                           const EvalOptions& options) {
  // The pairs are chosen on the aligned estimate: "10 m" are metres of the ground truth's scale.
  const auto pairs = pairsApart(est, options.delta, options.all_pairs);
  if (pairs.empty()) return std::nullopt;
  double trans2 = 0, rot2 = 0;
  for (const auto& [i, j] : pairs) {
    const SE3 motion_gt = gt[i].T_world_cam.inverse() * gt[j].T_world_cam;
    const SE3 motion_est = est[i].T_world_cam.inverse() * est[j].T_world_cam;
    const SE3 error = motion_gt.inverse() * motion_est;
    trans2 += error.translation().squaredNorm();
    rot2 += so3Log(error.quaternion()).squaredNorm();
  }
  const double n = static_cast<double>(pairs.size());
  return RelativeError{std::sqrt(trans2 / n), std::sqrt(rot2 / n), static_cast<int>(pairs.size())};
}

/// Positions of the first `count` poses.
std::vector<Vec3> positions(const Trajectory& poses, std::size_t count) {
  std::vector<Vec3> result;
  result.reserve(count);
  for (std::size_t i = 0; i < count; ++i) result.push_back(poses[i].T_world_cam.translation());
  return result;
}

/// `matched`: the poses of the ground truth that have a match, by time.
double coverageOf(const Trajectory& truth, const Trajectory& matched, bool by_row) {
  const double rows = static_cast<double>(matched.size()) / static_cast<double>(truth.size());
  const double whole = truth.back().timestamp - truth.front().timestamp;
  if (by_row || !(whole > 0)) return std::min(1.0, rows);
  std::vector<double> times;
  for (const StampedPose& pose : truth) times.push_back(pose.timestamp);
  const double limit = std::max(1.0, 2 * medianStep(times));
  double covered = 0;
  for (std::size_t i = 1; i < matched.size(); ++i) {
    const double gap = matched[i].timestamp - matched[i - 1].timestamp;
    if (gap > 0 && gap <= limit) covered += gap;
  }
  return covered / whole;
}

Trajectory shifted(const Trajectory& poses, double offset) {
  Trajectory result = poses;
  for (StampedPose& pose : result) pose.timestamp += offset;
  return result;
}

}  // namespace

ErrorStatistics statisticsOf(std::vector<double> values) {
  ErrorStatistics s;
  if (values.empty()) return s;
  std::sort(values.begin(), values.end());
  const double n = static_cast<double>(values.size());
  double sum = 0, sum2 = 0, squares = 0;
  for (const double v : values) {
    sum += v;
    sum2 += v * v;
  }
  const std::size_t middle = values.size() / 2;
  s.rmse = std::sqrt(sum2 / n);
  s.mean = sum / n;
  s.median = values.size() % 2 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
  s.min = values.front();
  s.max = values.back();
  for (const double v : values) squares += (v - s.mean) * (v - s.mean);
  s.stddev = std::sqrt(squares / n);
  return s;
}

Result<EvalResult> evaluate(const Trajectory& ground_truth, const Trajectory& estimate,
                            const EvalOptions& options) {
  const bool shift = options.time_offset != 0 && !options.by_row;
  const Trajectory estimate_on_clock =
      shift ? shifted(estimate, options.time_offset) : Trajectory();
  const Trajectory& stamped = shift ? estimate_on_clock : estimate;
  const auto pairs = options.by_row ? associateByRow(ground_truth, stamped)
                                    : associateByTime(ground_truth, stamped, options.max_dt);
  if (!pairs.ok()) return pairs.error();
  Trajectory gt, est;
  for (const PosePair& pair : pairs.value()) {
    gt.push_back(ground_truth[pair.gt]);
    est.push_back(stamped[pair.est]);
  }
  const std::size_t first =
      options.align_first > 0 ? static_cast<std::size_t>(options.align_first) : est.size();
  const std::size_t count = std::min(first, est.size());
  EvalResult result;
  const auto T_gt_est =
      alignPoints(positions(est, count), positions(gt, count), options.alignment, &result.straight);
  if (!T_gt_est.ok()) return T_gt_est.error();

  result.options = options;
  result.aligned_on = options.alignment == Alignment::none ? 0 : static_cast<int>(count);
  result.T_gt_est = T_gt_est.value();
  result.scale = result.T_gt_est.scale;
  result.matched = static_cast<int>(est.size());
  result.poses_gt = static_cast<int>(ground_truth.size());
  result.poses_est = static_cast<int>(estimate.size());
  result.coverage = coverageOf(ground_truth, gt, options.by_row);
  std::vector<double> distances;
  for (std::size_t i = 0; i < est.size(); ++i) {
    est[i].T_world_cam = result.T_gt_est * est[i].T_world_cam;
    const Vec3& p_gt = gt[i].T_world_cam.translation();
    const Vec3& p_est = est[i].T_world_cam.translation();
    distances.push_back((p_est - p_gt).norm());
    result.errors.push_back({est[i].timestamp, distances.back(), p_gt, p_est});
  }
  result.ate = statisticsOf(std::move(distances));
  if (options.orientations) result.rpe = relativeError(gt, est, options);
  if (!options.orientations) {
    result.rpe_note = "orientations are not known";
  } else if (!result.rpe) {
    result.rpe_note = "no matched poses are " + options.delta.text() + " apart";
  }
  return result;
}

}  // namespace svoscope
