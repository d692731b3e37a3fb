// SPDX-License-Identifier: MIT
#include "engine/mapping/map.h"

#include <algorithm>

namespace svoscope {

namespace {

void eraseValue(std::vector<std::int64_t>& values, std::int64_t value) {
  values.erase(std::remove(values.begin(), values.end(), value), values.end());
}

}  // namespace

Landmark& Map::addLandmark(const Vec3& p_world, FeatureType type) {
  Landmark landmark;
  landmark.id = next_id++;
  landmark.p_world = p_world;
  landmark.type = type;
  return landmarks.emplace(landmark.id, std::move(landmark)).first->second;
}

void Map::addObservation(Landmark& landmark, Keyframe& keyframe, const FeatureAnchor& anchor) {
  landmark.observations.push_back({keyframe.id, anchor});
  keyframe.landmarks.push_back(landmark.id);
}

void Map::removeLandmark(std::int64_t id) {
  const Landmark* landmark = find(id);
  if (!landmark) return;
  for (const LandmarkObservation& o : landmark->observations) {
    if (Keyframe* k = findKeyframe(o.keyframe_id)) eraseValue(k->landmarks, id);
  }
  landmarks.erase(id);
}

void Map::removeSegment(std::int64_t id) {
  const auto it = segments.find(id);
  if (it == segments.end()) return;
  for (const SegmentView& view : it->second.views) {
    if (Keyframe* k = findKeyframe(view.keyframe_id)) eraseValue(k->segments, id);
  }
  segments.erase(it);
}

void Map::removeSegmentView(std::int64_t id, int keyframe_id) {
  SegmentLandmark& segment = segments.at(id);
  // The prior belongs to the first view and goes with it.
  if (segment.views.front().keyframe_id == keyframe_id)
    segment.prior_sigma[0] = segment.prior_sigma[1] = 0;
  if (Keyframe* keyframe = findKeyframe(keyframe_id)) eraseValue(keyframe->segments, id);
  segment.views.erase(
      std::remove_if(segment.views.begin(), segment.views.end(),
                     [keyframe_id](const SegmentView& v) { return v.keyframe_id == keyframe_id; }),
      segment.views.end());
  if (segment.views.size() < 2) removeSegment(id);
}

void Map::removeObservation(std::int64_t landmark_id, int keyframe_id) {
  Landmark* landmark = find(landmark_id);
  if (!landmark) return;
  if (Keyframe* keyframe = findKeyframe(keyframe_id)) eraseValue(keyframe->landmarks, landmark_id);
  auto& views = landmark->observations;
  views.erase(std::remove_if(views.begin(), views.end(),
                             [keyframe_id](const LandmarkObservation& o) {
                               return o.keyframe_id == keyframe_id;
                             }),
              views.end());
  if (views.size() < 2) removeLandmark(landmark_id);
}

void Map::endSeeds(Keyframe& keyframe, SeedEnding ending) {
  const auto endAll = [&](auto& seeds, auto& left) {
    for (auto& seed : seeds) {
      endSeed(seed, ending);
      left.push_back({seed, keyframe.T_cam_world});
    }
    seeds.clear();
  };
  endAll(keyframe.seeds, orphans);
  endAll(keyframe.segment_seeds, segment_orphans);
}

void Map::removeKeyframe(int id) {
  Keyframe* keyframe = findKeyframe(id);
  if (!keyframe) return;
  const std::vector<std::int64_t> seen = keyframe->landmarks, seen_segments = keyframe->segments;
  for (const std::int64_t landmark_id : seen) removeObservation(landmark_id, id);
  for (const std::int64_t segment_id : seen_segments) removeSegmentView(segment_id, id);
  endSeeds(*keyframe, SeedEnding::keyframe_removed);
  retired.push_back({id, keyframe->frame_index, keyframe->T_cam_world.inverse()});
  keyframes.erase(id);
}

int Map::seedCount() const {
  int count = 0;
  for (const auto& [id, keyframe] : keyframes) {
    for (const Seed& seed : keyframe.seeds) count += alive(seed);
    for (const SegmentSeed& seed : keyframe.segment_seeds) count += alive(seed);
  }
  return count;
}

const LandmarkObservation* closestView(const Map& map, const Landmark& landmark,
                                       const Vec3& c_world, double min_cosine) {
  const Vec3 direction = (c_world - landmark.p_world).normalized();
  const LandmarkObservation* best = nullptr;
  double best_cosine = min_cosine;
  for (const LandmarkObservation& o : landmark.observations) {
    const auto it = map.keyframes.find(o.keyframe_id);
    if (it == map.keyframes.end()) continue;
    const Vec3 c = it->second.T_cam_world.inverse().translation();
    const double cosine = direction.dot((c - landmark.p_world).normalized());
    if (cosine > best_cosine) {
      best_cosine = cosine;
      best = &o;
    }
  }
  return best;
}

}  // namespace svoscope
