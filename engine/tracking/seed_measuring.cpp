// SPDX-License-Identifier: MIT
#include "engine/tracking/seed_measuring.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/base/angle.h"
#include "engine/mapping/segment_seed_update.h"
#include "engine/tracking/segment_tracking.h"

namespace svoscope {

namespace {

void update(Seed& seed, const SeedMeasurement& m, DepthFilterParameters filter, SeedLog& log) {
  filter.shadow = filter.shadow && log.inspected;
  if (!log.inspected) return applyMeasurement(seed, m, filter);
  const Seed before = seed;
  applyMeasurement(seed, m, filter);
  log.updates.push_back(describeUpdate(before, seed, m, filter.rule));
}

void count(const SeedLife& seed, SeedStatus before, SeedTally& tally) {
  tally.converged += seed.status == SeedStatus::converged && before == SeedStatus::active;
  tally.rejected += seed.status == SeedStatus::rejected;
}

/// Where the tracked feature puts the seed, and whether that is a measurement at all.
SeedMeasurement measurementOf(const TrackedSeedMatch& match, const TrackedFeature* feature,
                              const Seed& seed, const MappingParameters& p, const Map& map,
                              const Frame& frame) {
  SeedMeasurement m{match.seed_id, match.keyframe_id, frame.index, match.outcome};
  m.score = match.score;
  if (!feature) return m;
  m.px = feature->anchor.px;
  const Keyframe& keyframe = *map.findKeyframe(match.keyframe_id);
  const SE3 T_cur_ref = frame.T_cam_world * keyframe.T_cam_world.inverse();
  m.x = triangulateInverseDistance(map.camera, T_cur_ref, seed.anchor.f, feature->anchor.px);
  m.tau = inverseDistanceSigma(T_cur_ref, seed.anchor.f, m.x,
                               std::max(p.search.pixel_noise, frame.noise_px), map.camera.focal());
  const bool parallax =
      parallaxAt(T_cur_ref, seed.anchor.f, seed.belief.mu) > p.search.min_parallax_deg * kDegree;
  // Without a baseline the sign of x is chance, and no evidence against the seed.
  if (feature->status != FeatureStatus::inlier)
    m.outcome = SearchOutcome::no_match;
  else if (!parallax)
    m.outcome = SearchOutcome::low_parallax;
  else if (!(m.x > 0))
    m.outcome = SearchOutcome::no_match;
  return m;
}

SegmentMeasurement measurementOf(const TrackedSegment& s, const SegmentSeed& seed,
                                 const Keyframe& keyframe, const MappingParameters& p,
                                 const Pinhole& camera, const Frame& frame) {
  const SE3 T_cur_ref = frame.T_cam_world * keyframe.T_cam_world.inverse();
  SegmentMeasurement m = measureFromLine(camera, T_cur_ref, seed.anchor, s.anchor.px, p);
  m.frame_index = frame.index;
  for (int i = 0; i < 2; ++i) {
    const double parallax = parallaxAt(T_cur_ref, seed.anchor.f[i], seed.belief[i].mu);
    if (parallax < p.search.min_parallax_deg * kDegree) m.outcome = SearchOutcome::low_parallax;
  }
  if (s.status != FeatureStatus::inlier) m.outcome = SearchOutcome::no_match;
  return m;
}

void addPointSeeds(const MappingResult& result, const DepthFilterParameters& filter, Map& map,
                   SeedLog& log, SeedTally& tally) {
  Keyframe* keyframe = map.findKeyframe(result.keyframe_id);
  if (!keyframe) return;
  for (const NewSeed& fresh : result.new_seeds) {
    Seed seed = makeSeed(fresh.feature, map.camera, result.median_depth, result.min_depth, filter);
    seed.id = map.next_id++;
    seed.keyframe_id = keyframe->id;
    for (const SeedMeasurement& m : fresh.measurements) {
      update(seed, m, filter, log);
      ++tally.updates;
    }
    keyframe->seeds.push_back(seed);
  }
}

void addSegmentSeeds(const MappingResult& result, const DepthFilterParameters& filter, Map& map,
                     SeedTally& tally) {
  Keyframe* keyframe = map.findKeyframe(result.keyframe_id);
  if (!keyframe) return;
  for (const NewSegmentSeed& fresh : result.segments.new_seeds) {
    SegmentSeed seed = makeSegmentSeed(fresh.anchor, result.median_depth, result.min_depth, filter);
    seed.id = map.next_id++;
    seed.keyframe_id = keyframe->id;
    for (const SegmentMeasurement& m : fresh.measurements) applySegmentMeasurement(seed, m, filter);
    tally.segment_updates += static_cast<int>(fresh.measurements.size());
    keyframe->segment_seeds.push_back(seed);
  }
}

}  // namespace

std::vector<std::int64_t> measureMatches(const std::vector<TrackedSeedMatch>& matches,
                                         const MappingParameters& p, Map& map, Frame& frame,
                                         SeedLog& log, SeedTally& tally) {
  std::vector<std::int64_t> measured;
  for (const TrackedSeedMatch& match : matches) {
    Seed* seed = map.findSeed(match.keyframe_id, match.seed_id);
    if (!seed) continue;
    measured.push_back(match.seed_id);
    TrackedFeature* feature =
        match.feature < 0 ? nullptr : &frame.features[static_cast<std::size_t>(match.feature)];
    const SeedMeasurement m = measurementOf(match, feature, *seed, p, map, frame);
    const double fused = fusedInverseDistance(seed->belief, m.x, m.tau);
    const SeedStatus before = seed->status;
    update(*seed, m, p.filter, log);
    count(*seed, before, tally);
    tally.updates += m.outcome == SearchOutcome::tracked;
    if (!feature) continue;
    const Keyframe& keyframe = *map.findKeyframe(match.keyframe_id);
    const bool doubtful =
        seed->status == SeedStatus::active && m.outcome == SearchOutcome::tracked && fused > 0;
    // The pose confirmed the match: until the filter has made up its mind, the match counts.
    feature->p_world = doubtful ? Vec3(keyframe.T_cam_world.inverse() * (seed->anchor.f / fused))
                                : seedPoint(*seed, keyframe);
    if (seed->status == SeedStatus::rejected) feature->status = FeatureStatus::outlier;
  }
  std::sort(measured.begin(), measured.end());
  return measured;
}

void measureSegments(const MappingParameters& p, Map& map, Frame& frame, SeedTally& tally) {
  for (TrackedSegment& s : frame.segments) {
    SegmentSeed* seed =
        s.origin == FeatureOrigin::landmark ? nullptr : map.findSegmentSeed(s.keyframe_id, s.id);
    if (!seed) continue;
    const Keyframe& keyframe = *map.findKeyframe(s.keyframe_id);
    const SegmentMeasurement m = measurementOf(s, *seed, keyframe, p, map.camera, frame);
    const SeedStatus before = seed->status;
    applySegmentMeasurement(*seed, m, p.filter);
    count(*seed, before, tally);
    tally.segment_updates += m.outcome == SearchOutcome::tracked;
    setSeedPose(*seed, keyframe, s);
    if (seed->status == SeedStatus::rejected) s.status = FeatureStatus::outlier;
  }
}

void applyMeasurements(const MappingResult& result, const DepthFilterParameters& filter, Map& map,
                       SeedLog& log, SeedTally& tally) {
  for (const SeedMeasurement& m : result.measurements) {
    Seed* seed = map.findSeed(m.keyframe_id, m.seed_id);
    if (!seed || !alive(*seed)) continue;
    const SeedStatus before = seed->status;
    update(*seed, m, filter, log);
    count(*seed, before, tally);
    tally.updates += m.outcome == SearchOutcome::matched;
  }
  for (const SegmentMeasurement& m : result.segments.measurements) {
    SegmentSeed* seed = map.findSegmentSeed(m.keyframe_id, m.seed_id);
    if (!seed || !alive(*seed)) continue;
    const SeedStatus before = seed->status;
    applySegmentMeasurement(*seed, m, filter);
    count(*seed, before, tally);
    tally.segment_updates += m.outcome == SearchOutcome::matched;
  }
  // Segments first: ids are given in this order.
  addSegmentSeeds(result, filter, map, tally);
  addPointSeeds(result, filter, map, log, tally);
}

void bringToScale(const Map& map, MappingResult& result) {
  std::map<int, double> factors;
  for (const JobScale& then : result.scales) {
    const Keyframe* keyframe = map.findKeyframe(then.keyframe_id);
    if (keyframe && keyframe->scale != then.scale)
      factors[then.keyframe_id] = keyframe->scale / then.scale;
  }
  if (factors.empty()) return;
  const auto factor = [&](int keyframe_id) {
    const auto it = factors.find(keyframe_id);
    return it == factors.end() ? 1.0 : it->second;
  };
  const auto point = [](SeedMeasurement& m, double by) { m.x /= by, m.tau /= by; };
  const auto segment = [](SegmentMeasurement& m, double by) {
    for (int i = 0; i < 2; ++i) m.x[i] /= by, m.tau[i] /= by;
  };
  for (SeedMeasurement& m : result.measurements) point(m, factor(m.keyframe_id));
  for (SegmentMeasurement& m : result.segments.measurements) segment(m, factor(m.keyframe_id));
  const double own = factor(result.keyframe_id);
  for (NewSeed& fresh : result.new_seeds) {
    for (SeedMeasurement& m : fresh.measurements) point(m, own);
  }
  for (NewSegmentSeed& fresh : result.segments.new_seeds) {
    for (SegmentMeasurement& m : fresh.measurements) segment(m, own);
  }
  result.median_depth *= own;
  result.min_depth *= own;
}

}  // namespace svoscope
