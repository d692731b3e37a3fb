// SPDX-License-Identifier: MIT
// How the tracker changes the map: landmarks and keyframes. Seeds: tracker_seeds.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/angle.h"
#include "engine/base/quantile.h"
#include "engine/mapping/landmark_refinement.h"
#include "engine/tracking/tracker.h"

namespace svoscope {

bool depthStatistics(const Frame& frame, double& median, double& near) {
  std::vector<double> depths;
  for (const TrackedFeature& f : frame.features) {
    if (f.status != FeatureStatus::inlier) continue;
    const double z = (frame.T_cam_world * f.p_world).z();
    if (z > 0) depths.push_back(z);
  }
  if (depths.empty()) return false;
  median = quantile(depths, 0.5);
  near = quantile(std::move(depths), 0.05);
  return true;
}

void Tracker::refineStructure() {
  for (TrackedFeature& f : frame_.features) {
    if (f.origin != FeatureOrigin::landmark || f.status != FeatureStatus::inlier) continue;
    Landmark* landmark = map_.find(f.id);
    if (landmark && refineLandmark(*landmark, map_, parameters_.quality.structure_iterations))
      f.p_world = landmark->p_world;
  }
}

KeyframeDecision Tracker::considerKeyframe() {
  KeyframeEvidence e;
  e.frames_since_last = frame_.index - last_keyframe_frame_;
  const Keyframe* last_keyframe = map_.findKeyframe(latest_keyframe_);
  std::vector<double> moved;
  for (const TrackedFeature& f : frame_.features) {
    if (f.status != FeatureStatus::inlier) continue;
    ++e.inliers;
    if (f.origin != FeatureOrigin::landmark) continue;
    ++e.landmarks;
    const Landmark* landmark = map_.find(f.id);
    if (!landmark || !last_keyframe) continue;
    for (const LandmarkObservation& o : landmark->observations) {
      if (o.keyframe_id == latest_keyframe_) moved.push_back((o.anchor.px - f.anchor.px).norm());
    }
  }
  e.required = record_.funnel.required;
  e.shares_landmarks = !moved.empty();
  e.displacement_px = quantile(std::move(moved), 0.5) * 640.0 / map_.camera.width;
  double median = 1, near = 1;
  depthStatistics(frame_, median, near);
  e.nearest_distance = 1e9;
  e.nearest_angle_deg = 180;
  for (const int id : local_keyframes_) {
    const SE3 T = frame_.T_cam_world * map_.findKeyframe(id)->T_cam_world.inverse();
    const double distance = T.translation().norm() / median;
    if (distance >= e.nearest_distance) continue;
    e.nearest_distance = distance;
    e.nearest_angle_deg = so3Log(T.quaternion()).norm() / kDegree;
  }
  return decideKeyframe(e, parameters_.keyframe);
}

void Tracker::promoteFeature(TrackedFeature& f, Keyframe& keyframe) {
  if (f.origin == FeatureOrigin::landmark) {
    if (Landmark* landmark = map_.find(f.id)) map_.addObservation(*landmark, keyframe, f.anchor);
    return;
  }
  Seed* seed = map_.findSeed(f.keyframe_id, f.id);
  if (!seed) return;
  endSeed(*seed, SeedEnding::promoted);
  Landmark& landmark = map_.addLandmark(f.p_world, f.anchor.type);
  landmark.sigma = std::sqrt(seed->belief.sigma2);
  landmark.score = seed->score;
  map_.addObservation(landmark, *map_.findKeyframe(f.keyframe_id), seed->anchor);
  map_.addObservation(landmark, keyframe, f.anchor);
  f.origin = FeatureOrigin::landmark;
  f.id = landmark.id;
}

void Tracker::insertKeyframe(const std::string& reason) {
  const int id = map_.next_keyframe_id++;
  Keyframe& keyframe = map_.keyframes[id];
  keyframe.id = id;
  keyframe.frame_index = frame_.index;
  keyframe.timestamp = frame_.timestamp;
  keyframe.pyramid = frame_.pyramid;
  keyframe.T_cam_world = frame_.T_cam_world;
  keyframe.thumbnail = makeThumbnail(*frame_.pyramid);
  depthStatistics(frame_, keyframe.median_depth, keyframe.min_depth);
  for (TrackedFeature& f : frame_.features) {
    if (f.status == FeatureStatus::inlier) promoteFeature(f, keyframe);
  }
  promoteSegments(keyframe);
  refineStructure();
  refineSegments();
  last_keyframe_frame_ = frame_.index;
  latest_keyframe_ = id;
  record_.is_keyframe = true;
  record_.keyframe_id = id;
  event(EventKind::keyframe, fmt::format("keyframe {}: {}", id, reason));
  limitKeyframes();
  requestSeeds(keyframe);
  adjustment_wanted_ = true;
}

void Tracker::limitKeyframes() {
  while (static_cast<int>(map_.keyframes.size()) > parameters_.keyframe.max_keyframes) {
    const Vec3 c = frame_.T_cam_world.inverse().translation();
    int farthest = -1;
    double distance = -1;
    for (const auto& [id, keyframe] : map_.keyframes) {
      const double d = (keyframe.T_cam_world.inverse().translation() - c).norm();
      if (id != latest_keyframe_ && d > distance) {
        distance = d;
        farthest = id;
      }
    }
    map_.removeKeyframe(farthest);
    places_.forget(farthest);
    for (TrackedFeature& f : frame_.features) {
      // What the removal took from the map must not be used for the next alignment's bookkeeping.
      if (f.origin == FeatureOrigin::landmark ? !map_.find(f.id) : f.keyframe_id == farthest)
        f.status = FeatureStatus::outlier;
    }
    disownSegments(farthest);
    local_keyframes_.erase(std::remove(local_keyframes_.begin(), local_keyframes_.end(), farthest),
                           local_keyframes_.end());
  }
}

/// The world is the reference camera of the start, in units of its median depth.
void Tracker::buildMap(const InitializerOutput& start) {
  Keyframe& ref = map_.keyframes[map_.next_keyframe_id];
  ref.id = map_.next_keyframe_id++;
  ref.frame_index = start.reference_index;
  ref.timestamp = start.reference_timestamp;
  ref.pyramid = start.reference_pyramid;
  ref.thumbnail = makeThumbnail(*ref.pyramid);
  frame_.T_cam_world = start.T_cur_ref;
  for (const InitializerPoint& p : start.points) {
    const FeatureAnchor anchor{p.px_ref, map_.camera.bearing(p.px_ref), p.level, p.type,
                               p.gradient_dir};
    const Vec3 p_cur = frame_.T_cam_world * p.p_ref;
    if (p_cur.z() <= 0 || !map_.camera.inside(p.px_cur, 1)) continue;
    Landmark& landmark = map_.addLandmark(p.p_ref, p.type);
    landmark.sigma = p.sigma_inv_depth;
    map_.addObservation(landmark, ref, anchor);
    TrackedFeature f;
    f.origin = FeatureOrigin::landmark;
    f.id = landmark.id;
    f.keyframe_id = ref.id;
    f.anchor = {p.px_cur, map_.camera.bearing(p.px_cur), p.level, p.type, Vec2::Zero()};
    if (p.type == FeatureType::edgelet) {
      const Mat2 A = affineWarp(map_.camera, start.T_cur_ref, anchor.f, p.p_ref.norm());
      f.anchor.gradient_dir = (A.inverse().transpose() * p.gradient_dir).normalized();
    }
    f.p_world = p.p_ref;
    f.predicted_px = map_.camera.project(p_cur);
    f.error_px = (f.predicted_px - f.anchor.px).norm();
    frame_.features.push_back(f);
  }
  depthStatistics(frame_, ref.median_depth, ref.min_depth);
  local_keyframes_ = {ref.id};
  occupied_ = OccupancyGrid(map_.camera.width, map_.camera.height,
                            scaledCell(parameters_.reproject.cell_px, map_.camera.width));
  for (const TrackedFeature& f : frame_.features) occupied_.take(f.anchor.px);
  last_ = Frame{};  // the frames before the start have no pose
}

}  // namespace svoscope
