// SPDX-License-Identifier: MIT
#include "engine/tracking/landmark_keeping.h"

#include <algorithm>
#include <cmath>

#include "engine/mapping/landmark_refinement.h"
#include "engine/mapping/segment_refinement.h"

namespace svoscope {

namespace {

/// False if the landmark has failed too often.
template <class L>
bool countTry(L& landmark, FeatureStatus status, int max_failures) {
  ++(status == FeatureStatus::inlier ? landmark.succeeded : landmark.failed);
  return landmark.failed <= max_failures || landmark.failed <= landmark.succeeded / 4;
}

/// Sigma of the inverse distance over its mean, the worse of both ends.
double relativeSigma(const SegmentSeed& s) {
  double worst = 0;
  for (const Belief& b : s.belief)
    worst = std::max(worst, std::sqrt(b.sigma2) / std::max(b.mu, 1e-9));
  return worst;
}

void promotePoint(Map& map, TrackedFeature& f, Keyframe& keyframe) {
  if (f.origin == FeatureOrigin::landmark) {
    if (Landmark* landmark = map.find(f.id)) map.addObservation(*landmark, keyframe, f.anchor);
    return;
  }
  Seed* seed = map.findSeed(f.keyframe_id, f.id);
  if (!seed) return;
  endSeed(*seed, SeedEnding::promoted);
  Landmark& landmark = map.addLandmark(f.p_world, f.anchor.type);
  landmark.sigma = std::sqrt(seed->belief.sigma2);
  landmark.score = seed->score;
  map.addObservation(landmark, *map.findKeyframe(f.keyframe_id), seed->anchor);
  map.addObservation(landmark, keyframe, f.anchor);
  f.origin = FeatureOrigin::landmark;
  f.id = landmark.id;
}

void promoteSegmentSeed(SegmentSeed& seed, Map& map, TrackedSegment& s, Keyframe& keyframe) {
  endSeed(seed, SeedEnding::promoted);
  SegmentLandmark landmark;
  landmark.id = map.next_id++;
  for (int i = 0; i < 2; ++i) {
    landmark.p_world[i] = s.p_world[i];
    landmark.covariance[i] = s.covariance[i];
    landmark.prior[i] = seed.belief[i].mu;
    landmark.prior_sigma[i] = std::sqrt(seed.belief[i].sigma2);
  }
  landmark.views = {{seed.keyframe_id, seed.anchor}, {keyframe.id, s.anchor}};
  map.findKeyframe(seed.keyframe_id)->segments.push_back(landmark.id);
  keyframe.segments.push_back(landmark.id);
  s.origin = FeatureOrigin::landmark;
  s.id = landmark.id;
  map.segments.emplace(landmark.id, std::move(landmark));
}

}  // namespace

void countTries(const Registration& registration, const Frame& frame, const TrackerParameters& p,
                Map& map) {
  for (const auto* features : {&frame.features, &registration.failed_features}) {
    for (const TrackedFeature& f : *features) {
      Landmark* landmark = f.origin == FeatureOrigin::landmark ? map.find(f.id) : nullptr;
      if (landmark && !countTry(*landmark, f.status, p.reproject.max_failures))
        map.removeLandmark(f.id);
    }
  }
  for (const auto* segments : {&frame.segments, &registration.failed_segments}) {
    for (const TrackedSegment& s : *segments) {
      const auto it =
          s.origin == FeatureOrigin::landmark ? map.segments.find(s.id) : map.segments.end();
      if (it != map.segments.end() &&
          !countTry(it->second, s.status, p.mapping.segments.max_failures))
        map.removeSegment(s.id);
    }
  }
}

void refinePoints(int iterations, Map& map, Frame& frame) {
  for (TrackedFeature& f : frame.features) {
    if (f.origin != FeatureOrigin::landmark || f.status != FeatureStatus::inlier) continue;
    Landmark* landmark = map.find(f.id);
    if (landmark && refineLandmark(*landmark, map, iterations)) f.p_world = landmark->p_world;
  }
}

void refineSegments(double line_noise_px, int iterations, Map& map, Frame& frame) {
  for (TrackedSegment& s : frame.segments) {
    if (s.origin != FeatureOrigin::landmark || s.status != FeatureStatus::inlier) continue;
    const auto it = map.segments.find(s.id);
    if (it == map.segments.end()) continue;
    refineSegment(it->second, map, line_noise_px, iterations);
    for (int i = 0; i < 2; ++i) {
      s.p_world[i] = it->second.p_world[i];
      s.covariance[i] = it->second.covariance[i];
    }
  }
}

void promotePoints(Map& map, Frame& frame, Keyframe& keyframe) {
  for (TrackedFeature& f : frame.features) {
    if (f.status == FeatureStatus::inlier) promotePoint(map, f, keyframe);
  }
}

void promoteSegments(const MappingParameters& p, Map& map, Frame& frame, Keyframe& keyframe) {
  for (TrackedSegment& s : frame.segments) {
    if (s.status != FeatureStatus::inlier) continue;
    if (s.origin == FeatureOrigin::landmark) {
      const auto it = map.segments.find(s.id);
      if (it == map.segments.end()) continue;
      it->second.views.push_back({keyframe.id, s.anchor});
      keyframe.segments.push_back(s.id);
      continue;
    }
    SegmentSeed* seed = map.findSegmentSeed(s.keyframe_id, s.id);
    if (seed && seed->keyframe_id != keyframe.id &&
        relativeSigma(*seed) <= p.segments.promote_sigma &&
        seed->belief[0].inlierRatio() >= p.filter.min_inlier_ratio)
      promoteSegmentSeed(*seed, map, s, keyframe);
  }
}

void disownGone(const Map& map, int keyframe_id, Frame& frame) {
  for (TrackedFeature& f : frame.features) {
    if (f.origin == FeatureOrigin::landmark ? !map.find(f.id) : f.keyframe_id == keyframe_id)
      f.status = FeatureStatus::outlier;
  }
  for (TrackedSegment& s : frame.segments) {
    if (s.origin == FeatureOrigin::landmark ? !map.segments.count(s.id)
                                            : s.keyframe_id == keyframe_id)
      s.status = FeatureStatus::outlier;
  }
}

}  // namespace svoscope
