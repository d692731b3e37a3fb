// SPDX-License-Identifier: MIT
// When a frame becomes a keyframe, how, and which keyframe goes for it.
#include <algorithm>

#include "engine/base/angle.h"
#include "engine/base/quantile.h"
#include "engine/tracking/frame_summary.h"
#include "engine/tracking/landmark_keeping.h"
#include "engine/tracking/map_keeper.h"

namespace svoscope {

namespace {

/// Counts inliers; returns how far those moved that the last keyframe sees, too, px.
std::vector<double> countInliers(const Frame& frame, const Map& map, int latest_keyframe,
                                 KeyframeEvidence& e) {
  const bool known = map.findKeyframe(latest_keyframe) != nullptr;
  std::vector<double> moved;
  for (const TrackedFeature& f : frame.features) {
    if (f.status != FeatureStatus::inlier) continue;
    ++e.inliers;
    if (f.origin != FeatureOrigin::landmark) continue;
    ++e.landmarks;
    const Landmark* landmark = map.find(f.id);
    if (!landmark || !known) continue;
    for (const LandmarkObservation& o : landmark->observations) {
      if (o.keyframe_id == latest_keyframe) moved.push_back((o.anchor.px - f.anchor.px).norm());
    }
  }
  return moved;
}

void findNearest(const Frame& frame, const Map& map, const std::vector<int>& local_keyframes,
                 KeyframeEvidence& e) {
  double median = 1, near = 1;
  depthStatistics(frame, median, near);
  e.nearest_distance = 1e9;
  e.nearest_angle_deg = 180;
  for (const int id : local_keyframes) {
    const SE3 T = frame.T_cam_world * map.findKeyframe(id)->T_cam_world.inverse();
    const double distance = T.translation().norm() / median;
    if (distance >= e.nearest_distance) continue;
    e.nearest_distance = distance;
    e.nearest_angle_deg = so3Log(T.quaternion()).norm() / kDegree;
  }
}

/// The keyframe farthest from the frame, but for the latest.
int farthestKeyframe(const Map& map, const Frame& frame, int latest_keyframe) {
  const Vec3 c = frame.T_cam_world.inverse().translation();
  int farthest = -1;
  double distance = -1;
  for (const auto& [id, keyframe] : map.keyframes) {
    const double d = (keyframe.T_cam_world.inverse().translation() - c).norm();
    if (id != latest_keyframe && d > distance) {
      distance = d;
      farthest = id;
    }
  }
  return farthest;
}

}  // namespace

KeyframeDecision MapKeeper::considerKeyframe(const Frame& frame, int required,
                                             const KeyframeParameters& parameters) const {
  KeyframeEvidence e;
  e.frames_since_last = frame.index - last_keyframe_frame_;
  std::vector<double> moved = countInliers(frame, map_, latest_keyframe_, e);
  e.required = required;
  e.shares_landmarks = !moved.empty();
  e.displacement_px = quantile(std::move(moved), 0.5) * 640.0 / map_.camera.width;
  findNearest(frame, map_, local_keyframes_, e);
  return decideKeyframe(e, parameters);
}

int MapKeeper::insertKeyframe(const TrackerParameters& p, Frame& frame) {
  const int id = map_.next_keyframe_id++;
  Keyframe& keyframe = map_.keyframes[id];
  keyframe.id = id;
  keyframe.frame_index = frame.index;
  keyframe.timestamp = frame.timestamp;
  keyframe.pyramid = frame.pyramid;
  keyframe.T_cam_world = frame.T_cam_world;
  keyframe.thumbnail = makeThumbnail(*frame.pyramid);
  depthStatistics(frame, keyframe.median_depth, keyframe.min_depth);
  promotePoints(map_, frame, keyframe);
  promoteSegments(p.mapping, map_, frame, keyframe);
  refine(p, frame);
  last_keyframe_frame_ = frame.index;
  latest_keyframe_ = id;
  limitKeyframes(p.keyframe.max_keyframes, frame);
  adjustment_wanted_ = true;
  return id;
}

void MapKeeper::limitKeyframes(int most, Frame& frame) {
  while (static_cast<int>(map_.keyframes.size()) > most) {
    const int farthest = farthestKeyframe(map_, frame, latest_keyframe_);
    map_.removeKeyframe(farthest);
    disownGone(map_, farthest, frame);
    local_keyframes_.erase(std::remove(local_keyframes_.begin(), local_keyframes_.end(), farthest),
                           local_keyframes_.end());
  }
}

}  // namespace svoscope
