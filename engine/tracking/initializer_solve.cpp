// SPDX-License-Identifier: MIT
#include "engine/tracking/initializer_solve.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/geometry/triangulation.h"
#include "engine/geometry/two_view_bundle.h"

namespace svoscope {

namespace {

constexpr int kEdgeletsNeededBelow = 30;  // corners; with fewer, edgelets enter the two views
constexpr double kTwoViewSigmaPx = 0.5;   // generous: outliers of the joint fit go later
constexpr double kAmbiguousRatio = 1.1;      // of the joint costs of two explanations

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

template <typename... Args>
std::string format(const char* text, Args... args) {
  char buffer[200];
  std::snprintf(buffer, sizeof buffer, text, args...);
  return buffer;
}

/// The live tracks of a reference as a joint problem.
struct JointStart {
  std::vector<int> tracks;        ///< per point: index of its track
  std::vector<int> frames;        ///< per frame of the problem: index into reference.frames()
  MultiViewProblem problem;
  MultiViewSummary summary;
  double mean_cost = 0;           ///< truncated, per live track: to compare explanations
};

Vec2 unitPlane(const Pinhole& camera, const Vec2& px) { return camera.unproject(px).head<2>(); }

/// Frames evenly spaced in disparity, the last one included.
std::vector<int> chooseFrames(const InitializerReference& reference, int count) {
  const std::vector<TrackedFrame>& frames = reference.frames();
  const int last = static_cast<int>(frames.size()) - 1;
  std::vector<int> chosen;
  for (int n = 1; n < count; ++n) {
    const double wanted = frames.back().disparity_px * n / count;
    int best = -1;
    for (int k = 0; k < last; ++k)
      if (best < 0 || std::abs(frames[k].disparity_px - wanted) <
                          std::abs(frames[best].disparity_px - wanted))
        best = k;
    if (best >= 0) chosen.push_back(best);
  }
  chosen.push_back(last);
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  return chosen;
}

std::vector<Vec2> positions(const InitializerReference& reference, int frame,
                            const std::vector<int>& tracks, const Pinhole& camera) {
  std::vector<Vec2> x;
  for (int i : tracks)
    x.push_back(unitPlane(camera, reference.frames()[frame].px[i].cast<double>()));
  return x;
}

/// Pose of one frame from points of known depth.
SE3 poseFromPoints(const MultiViewProblem& points, const std::vector<Vec2>& x, const SE3& start,
                   double focal) {
  MultiViewProblem one;
  one.x_ref = points.x_ref;
  one.normal_ref = points.normal_ref;
  one.inv_depth = points.inv_depth;
  one.T_frame_ref = {start};
  one.x = {x};
  MultiViewOptions options;
  options.focal = focal;
  options.poses_only = true;
  refineMultiView(one, options);
  return one.T_frame_ref[0];
}

/// Points on which the two views agree, with the frames between them.
JointStart makeJoint(const InitializerReference& reference, const SE3& T_cur_ref,
                     const Pinhole& camera, const InitializerParameters& parameters) {
  JointStart joint;
  joint.frames = chooseFrames(reference, parameters.refine_frames);
  const double focal = camera.focal();
  const TrackedFrame& last = reference.frames().back();
  for (int i = 0; i < static_cast<int>(reference.tracks().size()); ++i) {
    const StartTrack& track = reference.tracks()[i];
    if (!track.alive) continue;
    const Vec2 x_ref = unitPlane(camera, track.feature.px);
    const Vec2 x_cur = unitPlane(camera, last.px[i].cast<double>());
    const TwoRayPoint point = triangulate(T_cur_ref, x_ref, x_cur);
    const bool edgelet = track.feature.type == FeatureType::edgelet;
    if (point.error * focal > (edgelet ? 6.0 : 3.0)) continue;
    if (!point.in_front && std::abs(point.inv_depth) > 3 * point.sigma / focal) continue;
    joint.tracks.push_back(i);
    joint.problem.x_ref.push_back(x_ref);
    joint.problem.normal_ref.push_back(edgelet ? track.feature.gradient_dir : Vec2::Zero());
    joint.problem.inv_depth.push_back(point.inv_depth);
  }
  joint.problem.T_frame_ref.assign(joint.frames.size(), T_cur_ref);
  for (int k : joint.frames)
    joint.problem.x.push_back(positions(reference, k, joint.tracks, camera));
  // Backwards in time, each pose starting from its successor's, shortened.
  for (int k = static_cast<int>(joint.frames.size()) - 2; k >= 0; --k) {
    SE3& T = joint.problem.T_frame_ref[k];
    T = poseFromPoints(joint.problem, joint.problem.x[k], joint.problem.T_frame_ref[k + 1], focal);
  }
  return joint;
}

/// Drops points that do not fit; true if any was dropped.
bool dropPoints(JointStart& joint, double limit_px) {
  MultiViewProblem& p = joint.problem;
  std::size_t kept = 0;
  const double typical = median(p.inv_depth);
  for (std::size_t i = 0; i < p.x_ref.size(); ++i) {
    const bool keep = joint.summary.point_px[i] < limit_px && p.inv_depth[i] > -0.05 * typical;
    if (!keep) continue;
    joint.tracks[kept] = joint.tracks[i];
    p.x_ref[kept] = p.x_ref[i];
    p.normal_ref[kept] = p.normal_ref[i];
    p.inv_depth[kept] = p.inv_depth[i];
    for (std::vector<Vec2>& x : p.x) x[kept] = x[i];
    ++kept;
  }
  const bool dropped = kept < p.x_ref.size();
  joint.tracks.resize(kept);
  p.x_ref.resize(kept);
  p.normal_ref.resize(kept);
  p.inv_depth.resize(kept);
  for (std::vector<Vec2>& x : p.x) x.resize(kept);
  return dropped;
}

void refineJoint(JointStart& joint, const Pinhole& camera, int live) {
  MultiViewOptions options;
  options.focal = camera.focal();
  for (int round = 0; round < 3 && joint.tracks.size() >= 8; ++round) {
    joint.summary = refineMultiView(joint.problem, options);
    const double limit = std::max(1.0, 3.0 * joint.summary.scale_px);
    if (!dropPoints(joint, limit)) break;
  }
  // Every live track that is not explained pays the limit.
  constexpr double kLimitPx = 2.0;
  double sum = kLimitPx * kLimitPx * std::max(0, live - static_cast<int>(joint.tracks.size()));
  if (joint.summary.point_px.size() == joint.tracks.size())
    for (double e : joint.summary.point_px) sum += std::min(kLimitPx * kLimitPx, e * e);
  joint.mean_cost = sum / std::max(1, live);
}

double rmsOf(const MultiViewSummary& summary) {
  double sum = 0;
  for (double e : summary.point_px) sum += e * e;
  return summary.point_px.empty()
             ? 0
             : std::sqrt(2 * sum / static_cast<double>(summary.point_px.size()));
}

/// Scales so that the median depth is 1 and fills points and poses of all frames.
void fillSolution(const InitializerReference& reference, const Pinhole& camera, JointStart joint,
                  StartSolution& out) {
  MultiViewProblem& p = joint.problem;
  std::vector<double> depths;
  for (double d : p.inv_depth)
    if (d > 0) depths.push_back(1 / d);
  const double scale = 1 / median(depths);
  for (double& d : p.inv_depth) d /= scale;
  for (SE3& T : p.T_frame_ref) T = SE3(T.quaternion(), T.translation() * scale);
  for (std::size_t i = 0; i < joint.tracks.size(); ++i)
    out.points.push_back({joint.tracks[i], p.inv_depth[i],
                          joint.summary.sigma_inv_depth[i] / scale, joint.summary.point_px[i]});
  const int frames = static_cast<int>(reference.frames().size());
  out.T_frame_ref.assign(static_cast<std::size_t>(frames), p.T_frame_ref.back());
  for (int k = frames - 2; k >= 0; --k) {
    const auto refined = std::find(joint.frames.begin(), joint.frames.end(), k);
    if (refined != joint.frames.end()) {
      out.T_frame_ref[k] = p.T_frame_ref[refined - joint.frames.begin()];
      continue;
    }
    const std::vector<Vec2> x = positions(reference, k, joint.tracks, camera);
    out.T_frame_ref[k] = poseFromPoints(p, x, out.T_frame_ref[k + 1], camera.focal());
  }
}

void judge(const JointStart& joint, const InitializerParameters& o, int live, StartSolution& out) {
  const int points = static_cast<int>(joint.tracks.size());
  const int wanted =
      std::max(o.min_inliers, static_cast<int>(std::ceil(o.min_inlier_ratio * live)));
  if (points < wanted) {
    out.verdict = TwoViewVerdict::too_few_inliers;
    out.reason = format("%d points of %d tracks fit, %d needed", points, live, wanted);
  } else if (!joint.summary.converged || out.rms_px > o.max_rms_px) {
    out.verdict = TwoViewVerdict::poor_fit;
    out.reason = format("rms %.2f px > %.2f px over the frames between", out.rms_px, o.max_rms_px);
  } else if (!(out.depth_sigma < o.max_depth_sigma)) {
    out.verdict = TwoViewVerdict::low_parallax;
    out.reason = format("depths uncertain by %.1f %% > %.1f %%", 100 * out.depth_sigma,
                        100 * o.max_depth_sigma);
  } else {
    out.verdict = TwoViewVerdict::ok;
    out.reason = format("%s start: %d points, rms %.2f px, depths to %.1f %%",
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
                                     o.model_error * median(turned));
  const double floor = median(joint.problem.inv_depth) / 3;
  std::vector<double> relative;
  for (std::size_t i = 0; i < joint.tracks.size(); ++i) {
    double& sigma = joint.summary.sigma_inv_depth[i];
    // The frames share the template's error: counting them as independent would be optimistic.
    sigma *= sigma_px * std::sqrt(static_cast<double>(joint.frames.size()));
    relative.push_back(sigma / std::max(joint.problem.inv_depth[i], floor));
  }
  return median(relative);
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

  std::vector<JointStart> joints;
  for (std::size_t k = 0; k < std::min<std::size_t>(3, two_view.candidates.size()); ++k) {
    const SE3& T = k == 0 ? two_view.T_cur_ref : two_view.candidates[k].T_cur_ref;
    joints.push_back(makeJoint(reference, T, camera, parameters));
    refineJoint(joints.back(), camera, reference.alive());
  }
  std::sort(joints.begin(), joints.end(),
            [](const JointStart& a, const JointStart& b) { return a.mean_cost < b.mean_cost; });
  JointStart& best = joints.front();
  if (best.tracks.size() < 8) {
    out.verdict = TwoViewVerdict::too_few_inliers;
    out.reason = format("%d points fit all frames", static_cast<int>(best.tracks.size()));
    return out;
  }
  for (std::size_t k = 1; k < joints.size(); ++k) {
    const SE3 D = joints[k].problem.T_frame_ref.back() * best.problem.T_frame_ref.back().inverse();
    if (D.log().norm() < 0.05 || joints[k].mean_cost > kAmbiguousRatio * best.mean_cost) continue;
    out.verdict = TwoViewVerdict::ambiguous;
    out.reason = format("two explanations fit alike: %.2f and %.2f px^2", best.mean_cost,
                        joints[k].mean_cost);
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
