// SPDX-License-Identifier: MIT
#include "engine/geometry/two_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/quantile.h"
#include "engine/geometry/triangulation.h"
#include "engine/geometry/two_view_bundle.h"
#include "engine/geometry/two_view_decompose.h"
#include "engine/geometry/two_view_models.h"

namespace svoscope {

namespace {

/// Torr's GRIC: fit, plus the price of the structure (d per correspondence) and of the model (k).
/// `errors` are distances with 4 - d degrees of freedom per correspondence.
double gric(const std::vector<double>& errors, double sigma, int d, int k) {
  const double n = static_cast<double>(errors.size());
  const double limit = 2.0 * (4 - d);
  double sum = 0;
  for (double e : errors) sum += std::min(limit, e * e / (sigma * sigma));
  return sum + std::log(4.0) * d * n + std::log(4.0 * n) * k;
}

TwoViewPose evaluate(const SE3& T, TwoViewModel model, const TwoViewData& data) {
  TwoViewPose pose;
  pose.T_cur_ref = T;
  pose.model = model;
  std::vector<double> errors = epipolarErrors(T, data);
  const std::vector<bool> front = inFront(T, data);
  for (int i = 0; i < data.size(); ++i) {
    if (!front[i]) errors[i] = data.inlier;
    pose.inliers += errors[i] < data.inlier;
  }
  pose.cost = truncatedCost(errors, data.inlier) * data.inlier * data.inlier /
              (data.sigma * data.sigma * data.size());
  return pose;
}

/// Same rotation within a degree and same direction within ten.
bool similar(const SE3& A, const SE3& B) {
  return A.quaternion().angularDistance(B.quaternion()) < 0.0175 &&
         A.translation().normalized().dot(B.translation().normalized()) > 0.985;
}

void addPose(std::vector<TwoViewPose>& poses, const TwoViewPose& pose) {
  for (TwoViewPose& other : poses)
    if (similar(other.T_cur_ref, pose.T_cur_ref)) {
      if (pose.cost < other.cost) other = pose;
      return;
    }
  poses.push_back(pose);
}

/// The poses of the homography that see its plane in front, refined as epipolar geometries.
void addPlanePoses(const Mat3& H, const TwoViewData& data, std::vector<TwoViewPose>& poses) {
  const std::vector<double> errors = homographyErrors(H, data);
  for (const PlanePose& plane : decomposeHomography(H)) {
    if (!(plane.T_cur_ref.translation().norm() > 1e-6)) continue;
    int seen = 0, behind = 0;
    for (int i = 0; i < data.size(); ++i)
      if (errors[i] < data.inlier)
        ++(plane.n_ref.dot(data.x_ref[i].homogeneous()) > 0 ? seen : behind);
    if (behind > seen) continue;
    const SE3 T(plane.T_cur_ref.quaternion(), plane.T_cur_ref.translation().normalized());
    addPose(poses, evaluate(T, TwoViewModel::homography, data));
    addPose(poses, evaluate(refineEpipolar(T, data, 20), TwoViewModel::homography, data));
  }
}

/// Structure, inliers and two-view bundle adjustment of the best pose.
void fillStructure(const TwoViewData& data, const TwoViewOptions& options, TwoViewResult& out) {
  MultiViewProblem problem;
  std::vector<int> index;
  const std::vector<double> errors = epipolarErrors(out.T_cur_ref, data);
  const std::vector<bool> front = inFront(out.T_cur_ref, data);
  problem.x.resize(1);
  problem.T_frame_ref = {out.T_cur_ref};
  for (int i = 0; i < data.size(); ++i) {
    if (errors[i] >= data.inlier || !front[i]) continue;
    index.push_back(i);
    problem.x_ref.push_back(data.x_ref[i]);
    problem.normal_ref.push_back(Vec2::Zero());
    problem.inv_depth.push_back(triangulate(out.T_cur_ref, data.x_ref[i], data.x_cur[i]).inv_depth);
    problem.x[0].push_back(data.x_cur[i]);
  }
  MultiViewOptions bundle;
  bundle.focal = options.focal;
  const MultiViewSummary summary = refineMultiView(problem, bundle);
  if (summary.converged) out.T_cur_ref = problem.T_frame_ref[0];
  std::vector<double> parallax;
  double sum = 0;
  for (std::size_t j = 0; j < index.size(); ++j) {
    if (!(summary.point_px[j] < options.inlier_px)) continue;
    out.inlier[index[j]] = true;
    out.inv_depth[index[j]] = problem.inv_depth[j];
    parallax.push_back(parallaxAngle(out.T_cur_ref, problem.x_ref[j], problem.x[0][j]));
    sum += 2 * summary.point_px[j] * summary.point_px[j];
    ++out.inliers;
  }
  out.rms_px = out.inliers > 0 ? std::sqrt(sum / out.inliers) : 0;
  out.parallax_deg = upperMedian(parallax) * 180 / M_PI;
}

void judge(const TwoViewOptions& o, int tracks, TwoViewResult& out) {
  const double best_gric = std::min(out.gric_homography, out.gric_essential);
  const int wanted =
      std::max(o.min_inliers, static_cast<int>(std::ceil(o.min_inlier_ratio * tracks)));
  if (out.gric_rotation <= best_gric) {
    out.verdict = TwoViewVerdict::rotation_only;
    out.reason = fmt::format("a rotation explains the motion: {:.1f} px left of {:.1f} px",
                             out.rotation_residual_px, out.disparity_px);
  } else if (out.rotation_residual_px < o.min_disparity_px) {
    out.verdict = TwoViewVerdict::low_parallax;
    out.reason = fmt::format("disparity without rotation {:.1f} px < {:.1f} px",
                             out.rotation_residual_px, o.min_disparity_px);
  } else if (out.inliers < wanted) {
    out.verdict = TwoViewVerdict::too_few_inliers;
    out.reason = fmt::format("{} inliers of {} < {}", out.inliers, tracks, wanted);
  } else if (out.candidates.size() > 1) {
    out.verdict = TwoViewVerdict::ambiguous;
    out.reason =
        fmt::format("{} poses explain the motion alike", static_cast<int>(out.candidates.size()));
  } else {
    out.verdict = TwoViewVerdict::ok;
    out.reason = fmt::format("{}, {} inliers of {}, {:.2f} px", twoViewModelName(out.model),
                             out.inliers, tracks, out.rms_px);
  }
}

std::vector<TwoViewPose> findPoses(const TwoViewData& data, const Eigen::Quaterniond& q,
                                   const Mat3& H, const std::vector<SE3>& hints) {
  std::vector<TwoViewPose> poses;
  addPlanePoses(H, data, poses);
  // Starts with the best rotation and plain directions: cheap, and enough for most video.
  std::vector<SE3> starts = hints;
  for (const TwoViewPose& pose : poses) starts.push_back(pose.T_cur_ref);
  for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
    for (double sign : {1.0, -1.0}) starts.emplace_back(q, Vec3(sign * axis));
  addPose(poses, evaluate(fitEssential(data, starts), TwoViewModel::essential, data));
  std::sort(poses.begin(), poses.end(),
            [](const TwoViewPose& a, const TwoViewPose& b) { return a.cost < b.cost; });
  return poses;
}

}  // namespace

const char* twoViewModelName(TwoViewModel model) {
  switch (model) {
    case TwoViewModel::none:
      return "none";
    case TwoViewModel::rotation:
      return "rotation";
    case TwoViewModel::homography:
      return "homography";
    case TwoViewModel::essential:
      return "essential";
  }
  return "?";
}

TwoViewResult estimateTwoView(const std::vector<Vec2>& x_ref, const std::vector<Vec2>& x_cur,
                              const TwoViewOptions& options, const std::vector<SE3>& hints) {
  TwoViewResult out;
  const int tracks = static_cast<int>(x_ref.size());
  out.inlier.assign(x_ref.size(), false);
  out.inv_depth.assign(x_ref.size(), 0.0);
  out.reason = fmt::format("{} tracks < {}", tracks, options.min_tracks);
  if (tracks < std::max(8, options.min_tracks)) return out;

  const TwoViewData data{x_ref,
                         x_cur,
                         options.sigma_px / options.focal,
                         options.inlier_px / options.focal,
                         options.max_samples,
                         options.seed};
  std::vector<double> moved;
  for (int i = 0; i < tracks; ++i) moved.push_back((x_ref[i] - x_cur[i]).norm() * options.focal);
  out.disparity_px = upperMedian(moved);

  const Eigen::Quaterniond q = fitRotation(data);
  const std::vector<double> e_rotation = rotationErrors(q, data);
  out.rotation_residual_px = upperMedian(e_rotation) * options.focal;
  out.gric_rotation = gric(e_rotation, data.sigma, 2, 3);
  const Mat3 H = fitHomography(data);
  out.gric_homography = gric(homographyErrors(H, data), data.sigma, 2, 8);

  std::vector<TwoViewPose> poses = findPoses(data, q, H, hints);
  const TwoViewPose best = poses.front();
  out.gric_essential = gric(epipolarErrors(best.T_cur_ref, data), data.sigma, 3, 5);
  out.model =
      out.gric_homography < out.gric_essential ? TwoViewModel::homography : TwoViewModel::essential;
  for (const TwoViewPose& pose : poses)
    if (pose.cost < options.max_candidate_ratio * best.cost + 0.05) out.candidates.push_back(pose);
  out.T_cur_ref = best.T_cur_ref;
  fillStructure(data, options, out);
  judge(options, tracks, out);
  return out;
}

}  // namespace svoscope
