// SPDX-License-Identifier: MIT
#include "engine/tracking/map_adjustment.h"

#include <algorithm>
#include <map>
#include <set>

#include "engine/mapping/segment_refinement.h"
#include "engine/tracking/reprojector.h"
#include "engine/tracking/segment_tracking.h"

namespace svoscope {

namespace {

/// The adjustment leaves the scale free where no keyframe holds it. How far it moved the other
/// keyframes from this one tells by how much everything there has to follow that was measured
/// between them. (The distances of landmarks tell less: they also change because they were wrong.)
double scaleOf(int keyframe, const std::map<int, KeyframeChange>& changes) {
  const KeyframeChange& own = changes.at(keyframe);
  double before = 0, after = 0;
  for (const auto& [id, other] : changes) {
    before += (other.T_cam_world_old * own.T_cam_world_old.inverse()).translation().norm();
    after += (other.T_cam_world_new * own.T_cam_world_new.inverse()).translation().norm();
  }
  return before > 1e-6 && after > 1e-6 ? after / before : 1.0;
}

std::map<int, KeyframeChange> changesBy(const AdjustmentResult& adjustment, const Map& map) {
  std::map<int, KeyframeChange> changes;
  for (const AdjustmentKeyframe& k : adjustment.keyframes) {
    const auto it = map.keyframes.find(k.id);
    if (it != map.keyframes.end()) changes[k.id] = {it->second.T_cam_world, k.T_cam_world, 1.0};
  }
  for (auto& [id, change] : changes) change.scale = scaleOf(id, changes);
  return changes;
}

/// Keyframes taken while the adjustment was computed go along with the newest one it knew.
void addYounger(const Map& map, std::map<int, KeyframeChange>& changes) {
  const auto [newest, by] = *changes.rbegin();
  for (auto it = map.keyframes.upper_bound(newest); it != map.keyframes.end(); ++it)
    changes[it->first] = {it->second.T_cam_world, by.followed(it->second.T_cam_world), by.scale};
}

/// Landmarks that were no part of the problem follow the keyframe that saw them first.
void moveLandmarks(const AdjustmentResult& adjustment, const std::map<int, KeyframeChange>& changes,
                   Map& map) {
  std::set<std::int64_t> adjusted;
  for (const AdjustmentPoint& p : adjustment.points) {
    adjusted.insert(p.id);
    if (Landmark* landmark = map.find(p.id)) landmark->p_world = p.p_world;
  }
  for (auto& [id, landmark] : map.landmarks) {
    const auto first = changes.find(landmark.observations.front().keyframe_id);
    if (first != changes.end() && !adjusted.count(id))
      landmark.p_world = first->second.moved(landmark.p_world);
  }
}

void rescale(Belief& belief, double scale) {
  belief.mu /= scale;
  belief.sigma2 /= scale * scale;
}

void rescaleSeeds(Keyframe& keyframe, double scale) {
  for (Seed& seed : keyframe.seeds) {
    rescale(seed.belief, scale);
    for (Belief& shadow : seed.shadow) rescale(shadow, scale);
    seed.range /= scale;
  }
  for (SegmentSeed& seed : keyframe.segment_seeds) {
    for (Belief& belief : seed.belief) rescale(belief, scale);
    seed.range /= scale;
  }
  keyframe.scale *= scale;
  keyframe.median_depth *= scale;
  keyframe.min_depth *= scale;
}

/// A segment follows its first view unless it was adjusted itself; its lines then settle it.
void moveSegments(const AdjustmentResult& adjustment, const std::map<int, KeyframeChange>& changes,
                  const SegmentParameters& p, int iterations, Map& map) {
  std::set<std::int64_t> adjusted;
  for (const AdjustmentEnd& end : adjustment.ends) {
    const auto it = map.segments.find(end.segment_id);
    if (it == map.segments.end()) continue;
    it->second.p_world[end.end] = end.p_world;
    adjusted.insert(end.segment_id);
  }
  for (auto& [id, segment] : map.segments) {
    const auto first = changes.find(segment.views.front().keyframe_id);
    if (first != changes.end()) {
      for (int i = 0; i < 2; ++i) {
        segment.prior[i] /= first->second.scale;
        segment.prior_sigma[i] /= first->second.scale;
        segment.covariance[i] *= first->second.scale * first->second.scale;
        if (!adjusted.count(id)) segment.p_world[i] = first->second.moved(segment.p_world[i]);
      }
    }
    const bool touched =
        std::any_of(segment.views.begin(), segment.views.end(),
                    [&](const SegmentView& v) { return changes.count(v.keyframe_id) > 0; });
    if (touched) refineSegment(segment, map, p.line_noise_px, iterations);
  }
}

void dropOutliers(const AdjustmentResult& adjustment, Map& map) {
  for (const AdjustmentResult::Outlier& o : adjustment.outliers)
    map.removeObservation(o.landmark_id, o.keyframe_id);
  for (const AdjustmentResult::Outlier& o : adjustment.segment_outliers) {
    if (map.segments.count(o.landmark_id)) map.removeSegmentView(o.landmark_id, o.keyframe_id);
  }
}

/// The frame goes along with the newest keyframe of the window, its features and segments take the
/// places of their landmarks and seeds.
void followFrame(const KeyframeChange& newest, Map& map, Frame& frame) {
  frame.T_cam_world = newest.followed(frame.T_cam_world);
  for (TrackedFeature& f : frame.features) {
    if (f.origin == FeatureOrigin::landmark) {
      const Landmark* landmark = map.find(f.id);
      f.p_world = landmark ? landmark->p_world : newest.moved(f.p_world);
    } else if (const Seed* seed = map.findSeed(f.keyframe_id, f.id)) {
      f.p_world = seedPoint(*seed, *map.findKeyframe(f.keyframe_id));
    }
  }
  for (TrackedSegment& s : frame.segments) {
    const auto it = map.segments.find(s.id);
    if (s.origin == FeatureOrigin::landmark && it != map.segments.end()) {
      for (int i = 0; i < 2; ++i) s.p_world[i] = it->second.p_world[i];
    } else if (const SegmentSeed* seed = map.findSegmentSeed(s.keyframe_id, s.id)) {
      setSeedPose(*seed, *map.findKeyframe(s.keyframe_id), s);
    }
  }
}

}  // namespace

std::optional<KeyframeChange> adoptAdjustment(const AdjustmentResult& adjustment,
                                              const SegmentParameters& segments,
                                              int structure_iterations, Map& map, Frame& frame) {
  if (!adjustment.ok) return std::nullopt;
  std::map<int, KeyframeChange> changes = changesBy(adjustment, map);
  if (changes.empty()) return std::nullopt;
  addYounger(map, changes);
  moveLandmarks(adjustment, changes, map);
  for (const auto& [id, change] : changes) {
    Keyframe& keyframe = *map.findKeyframe(id);
    keyframe.T_cam_world = change.T_cam_world_new;
    if (change.scale != 1) rescaleSeeds(keyframe, change.scale);
  }
  moveSegments(adjustment, changes, segments, structure_iterations, map);
  dropOutliers(adjustment, map);
  const KeyframeChange newest = changes.rbegin()->second;
  followFrame(newest, map, frame);
  return newest;
}

}  // namespace svoscope
