// SPDX-License-Identifier: MIT
#include "engine/tracking/initializer_solve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/quantile.h"
#include "engine/tracking/initializer_joint.h"

namespace svoscope {

namespace {

constexpr int kEdgeletsNeededBelow = 30;  // corners; with fewer, edgelets enter the two views
constexpr double kTwoViewSigmaPx = 0.5;   // generous: outliers of the joint fit go later
constexpr double kAmbiguousRatio = 1.1;   // of the joint costs of two explanations

/// Scales so that the median depth is 1 and fills points and poses of all frames.
void fillSolution(const InitializerReference& reference, const Pinhole& camera, JointStart joint,
                  StartSolution& out) {
  MultiViewProblem& p = joint.problem;
  std::vector<double> depths;
  for (double d : p.inv_depth)
    if (d > 0) depths.push_back(1 / d);
  const double scale = 1 / upperMedian(depths);
  for (double& d : p.inv_depth) d /= scale;
  for (SE3& T : p.T_frame_ref) T = SE3(T.quaternion(), T.translation() * scale);
  for (std::size_t i = 0; i < joint.tracks.size(); ++i)
    out.points.push_back({joint.tracks[i], p.inv_depth[i], joint.summary.sigma_inv_depth[i] / scale,
                          joint.summary.point_px[i]});
  out.T_frame_ref = posesOfAllFrames(reference, joint, camera);
}

void judge(const JointStart& joint, const InitializerParameters& o, int live, StartSolution& out) {
  const int points = static_cast<int>(joint.tracks.size());
  const int wanted =
      std::max(o.min_inliers, static_cast<int>(std::ceil(o.min_inlier_ratio * live)));
  if (points < wanted) {
    out.verdict = TwoViewVerdict::too_few_inliers;
    out.reason = fmt::format("{} points of {} tracks fit, {} needed", points, live, wanted);
  } else if (!joint.summary.converged || out.rms_px > o.max_rms_px) {
    out.verdict = TwoViewVerdict::poor_fit;
    out.reason =
        fmt::format("rms {:.2f} px > {:.2f} px over the frames between", out.rms_px, o.max_rms_px);
  } else if (!(out.depth_sigma < o.max_depth_sigma)) {
    out.verdict = TwoViewVerdict::low_parallax;
    out.reason = fmt::format("depths uncertain by {:.1f} % > {:.1f} %", 100 * out.depth_sigma,
                             100 * o.max_depth_sigma);
  } else {
    out.verdict = TwoViewVerdict::ok;
    out.reason =
        fmt::format("{} start: {} points, rms {:.2f} px, depths to {:.1f} %",
                    twoViewModelName(out.model), points, out.rms_px, 100 * out.depth_sigma);
  }
}

/// Median uncertainty of depth relative to depth (for far points relative to a third of the
/// median inverse depth: nothing better is asked of the background).
double depthSigma(JointStart& joint, const Pinhole& camera, const InitializerParameters& o) {
  std::vector<double> turned;
  const Eigen::Quaterniond& q = joint.problem.T_frame_ref.back().quaternion();
  for (const Vec2& x : joint.problem.x_ref)
    turned.push_back(((q * x.homogeneous()).hnormalized() - x).norm() * camera.focal());
  // A wrong lens or a rolling shutter bends the image in step with its rotation, and the fit
  // takes that for translation without leaving residuals.
  const double sigma_px = std::hypot(std::max(o.noise_px, 2 * joint.summary.scale_px),
                                     o.model_error * upperMedian(turned));
  const double floor = upperMedian(joint.problem.inv_depth) / 3;
  std::vector<double> relative;
  for (std::size_t i = 0; i < joint.tracks.size(); ++i) {
    double& sigma = joint.summary.sigma_inv_depth[i];
    // The frames share the template's error: counting them as independent would be optimistic.
    sigma *= sigma_px * std::sqrt(static_cast<double>(joint.frames.size()));
    relative.push_back(sigma / std::max(joint.problem.inv_depth[i], floor));
  }
  return upperMedian(relative);
}

TwoViewResult solveTwoView(const InitializerReference& reference, const Pinhole& camera,
                           const InitializerParameters& parameters) {
  int corners = 0;
  for (const StartTrack& t : reference.tracks())
    corners += t.alive && t.feature.type == FeatureType::corner;
  std::vector<Vec2> x_ref, x_cur;
  for (const StartTrack& t : reference.tracks()) {
    if (!t.alive) continue;
    if (corners >= kEdgeletsNeededBelow && t.feature.type != FeatureType::corner) continue;
    x_ref.push_back(unitPlane(camera, t.feature.px));
    x_cur.push_back(unitPlane(camera, t.px));
  }
  TwoViewOptions options;
  options.focal = camera.focal();
  options.sigma_px = kTwoViewSigmaPx;
  options.min_tracks = parameters.min_tracks;
  options.min_inliers = parameters.min_inliers;
  options.min_inlier_ratio = parameters.min_inlier_ratio;
  options.min_disparity_px = parameters.min_parallax_px;
  options.max_samples = parameters.max_samples;
  return estimateTwoView(x_ref, x_cur, options, reference.hints);
}

/// Every pose two views allow, refined over more frames; the best explanation first.
std::vector<JointStart> explain(const InitializerReference& reference,
                                const TwoViewResult& two_view, const Pinhole& camera,
                                const InitializerParameters& parameters) {
  std::vector<JointStart> joints;
  for (std::size_t k = 0; k < std::min<std::size_t>(3, two_view.candidates.size()); ++k) {
    const SE3& T = k == 0 ? two_view.T_cur_ref : two_view.candidates[k].T_cur_ref;
    joints.push_back(makeJoint(reference, T, camera, parameters));
    refineJoint(joints.back(), camera, reference.alive());
  }
  std::sort(joints.begin(), joints.end(),
            [](const JointStart& a, const JointStart& b) { return a.mean_cost < b.mean_cost; });
  return joints;
}

/// A different explanation that fits about as well as the first; null if there is none.
const JointStart* rival(const std::vector<JointStart>& joints) {
  const JointStart& best = joints.front();
  for (std::size_t k = 1; k < joints.size(); ++k) {
    const SE3 D = joints[k].problem.T_frame_ref.back() * best.problem.T_frame_ref.back().inverse();
    if (D.log().norm() > 0.05 && joints[k].mean_cost < kAmbiguousRatio * best.mean_cost)
      return &joints[k];
  }
  return nullptr;
}

}  // namespace

StartSolution solveStart(const InitializerReference& reference, const Pinhole& camera,
                         const InitializerParameters& parameters) {
  const TwoViewResult two_view = solveTwoView(reference, camera, parameters);
  StartSolution out;
  out.verdict = two_view.verdict;
  out.model = two_view.model;
  out.reason = two_view.reason;
  out.parallax_deg = two_view.parallax_deg;
  out.rotation_residual_px = two_view.rotation_residual_px;
  if (out.verdict != TwoViewVerdict::ok && out.verdict != TwoViewVerdict::ambiguous) return out;

  std::vector<JointStart> joints = explain(reference, two_view, camera, parameters);
  JointStart& best = joints.front();
  if (best.tracks.size() < 8) {
    out.verdict = TwoViewVerdict::too_few_inliers;
    out.reason = fmt::format("{} points fit all frames", static_cast<int>(best.tracks.size()));
    return out;
  }
  if (const JointStart* other = rival(joints)) {
    out.verdict = TwoViewVerdict::ambiguous;
    out.reason = fmt::format("two explanations fit alike: {:.2f} and {:.2f} px^2", best.mean_cost,
                             other->mean_cost);
    return out;
  }
  out.rms_px = rmsOf(best.summary);
  out.scale_px = best.summary.scale_px;
  out.depth_sigma = depthSigma(best, camera, parameters);
  out.T_cur_ref = best.problem.T_frame_ref.back();
  judge(best, parameters, reference.alive(), out);
  if (out.verdict == TwoViewVerdict::ok) fillSolution(reference, camera, std::move(best), out);
  return out;
}

}  // namespace svoscope
