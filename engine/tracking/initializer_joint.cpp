// SPDX-License-Identifier: MIT
#include "engine/tracking/initializer_joint.h"

#include <algorithm>
#include <cmath>

#include "engine/base/quantile.h"
#include "engine/geometry/triangulation.h"

namespace svoscope {

namespace {

/// Frames evenly spaced in disparity, the last one included.
std::vector<int> chooseFrames(const InitializerReference& reference, int count) {
  const std::vector<TrackedFrame>& frames = reference.frames();
  const int last = static_cast<int>(frames.size()) - 1;
  std::vector<int> chosen;
  for (int n = 1; n < count; ++n) {
    const double wanted = frames.back().disparity_px * n / count;
    int best = -1;
    for (int k = 0; k < last; ++k)
      if (best < 0 ||
          std::abs(frames[k].disparity_px - wanted) < std::abs(frames[best].disparity_px - wanted))
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

/// Drops points that do not fit; true if any was dropped.
bool dropPoints(JointStart& joint, double limit_px) {
  MultiViewProblem& p = joint.problem;
  std::size_t kept = 0;
  const double typical = upperMedian(p.inv_depth);
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

}  // namespace

Vec2 unitPlane(const Pinhole& camera, const Vec2& px) { return camera.unproject(px).head<2>(); }

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

std::vector<SE3> posesOfAllFrames(const InitializerReference& reference, const JointStart& joint,
                                  const Pinhole& camera) {
  const MultiViewProblem& p = joint.problem;
  const int frames = static_cast<int>(reference.frames().size());
  std::vector<SE3> poses(static_cast<std::size_t>(frames), p.T_frame_ref.back());
  for (int k = frames - 2; k >= 0; --k) {
    const auto refined = std::find(joint.frames.begin(), joint.frames.end(), k);
    if (refined != joint.frames.end()) {
      poses[k] = p.T_frame_ref[refined - joint.frames.begin()];
      continue;
    }
    const std::vector<Vec2> x = positions(reference, k, joint.tracks, camera);
    poses[k] = poseFromPoints(p, x, poses[k + 1], camera.focal());
  }
  return poses;
}

}  // namespace svoscope
