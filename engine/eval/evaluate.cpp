// SPDX-License-Identifier: MIT
#include "engine/eval/evaluate.h"

#include <algorithm>
#include <cmath>

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

std::vector<Vec3> positions(const Trajectory& poses) {
  std::vector<Vec3> result;
  result.reserve(poses.size());
  for (const StampedPose& pose : poses) result.push_back(pose.T_world_cam.translation());
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
  const auto pairs = options.by_row ? associateByRow(ground_truth, estimate)
                                    : associateByTime(ground_truth, estimate, options.max_dt);
  if (!pairs.ok()) return pairs.error();
  Trajectory gt, est;
  for (const PosePair& pair : pairs.value()) {
    gt.push_back(ground_truth[pair.gt]);
    est.push_back(estimate[pair.est]);
  }
  const auto T_gt_est = alignPoints(positions(est), positions(gt), options.alignment);
  if (!T_gt_est.ok()) return T_gt_est.error();

  EvalResult result;
  result.options = options;
  result.T_gt_est = T_gt_est.value();
  result.scale = result.T_gt_est.scale;
  result.matched = static_cast<int>(est.size());
  result.poses_gt = static_cast<int>(ground_truth.size());
  result.poses_est = static_cast<int>(estimate.size());
  std::vector<double> distances;
  for (std::size_t i = 0; i < est.size(); ++i) {
    est[i].T_world_cam = result.T_gt_est * est[i].T_world_cam;
    const Vec3& p_gt = gt[i].T_world_cam.translation();
    const Vec3& p_est = est[i].T_world_cam.translation();
    distances.push_back((p_est - p_gt).norm());
    result.errors.push_back({est[i].timestamp, distances.back(), p_gt, p_est});
  }
  result.ate = statisticsOf(std::move(distances));
  result.rpe = relativeError(gt, est, options);
  return result;
}

}  // namespace svoscope
