// SPDX-License-Identifier: MIT
// The tracker's seeds: measured by itself, given to the mapping thread to be measured, and ended.
#include <algorithm>
#include <cmath>
#include <map>

#include "engine/base/angle.h"
#include "engine/tracking/tracker.h"

namespace svoscope {

namespace {

constexpr std::size_t kMostJobSeeds = 800;
constexpr std::size_t kOlderViews = 3;
constexpr int kSeedMemoryFrames = 60;

}  // namespace

/// Ended seeds stay for one frame, so that its snapshot shows how they ended. Keyframes long out of
/// sight lose theirs: the cost of a frame must not grow with the path.
void Tracker::dropEndedSeeds() {
  for (const int id : local_keyframes_) {
    if (Keyframe* keyframe = map_.findKeyframe(id)) keyframe->last_local_frame = frame_.index;
  }
  map_.orphans.clear();
  map_.segment_orphans.clear();
  for (auto& [id, keyframe] : map_.keyframes) {
    if (frame_.index - std::max(keyframe.last_local_frame, keyframe.frame_index) >
        kSeedMemoryFrames)
      map_.endSeeds(keyframe, SeedEnding::out_of_sight);
    dropEnded(keyframe.seeds);
    dropEnded(keyframe.segment_seeds);
  }
}

/// Applies a measurement; true if the seed converged by it.
bool Tracker::measureSeed(Seed& seed, const SeedMeasurement& m) {
  const SeedStatus status = seed.status;
  DepthFilterParameters filter = parameters_.mapping.filter;
  filter.shadow = filter.shadow && inspected_;
  if (inspected_) {
    const Seed before = seed;
    applyMeasurement(seed, m, filter);
    seed_updates_.push_back(describeUpdate(before, seed, m, filter.rule));
  } else {
    applyMeasurement(seed, m, filter);
  }
  return seed.status == SeedStatus::converged && status == SeedStatus::active;
}

/// Measurements made by the tracker enter the filter with the final pose.
void Tracker::commitSeedMatches(const std::vector<TrackedSeedMatch>& matches) {
  for (const TrackedSeedMatch& match : matches) {
    Seed* seed = map_.findSeed(match.keyframe_id, match.seed_id);
    if (!seed) continue;
    measured_seeds_.push_back(match.seed_id);
    SeedMeasurement m{match.seed_id, match.keyframe_id, frame_.index, match.outcome};
    m.score = match.score;
    TrackedFeature* feature =
        match.feature < 0 ? nullptr : &frame_.features[static_cast<std::size_t>(match.feature)];
    if (feature) {
      m.px = feature->anchor.px;
      const Keyframe& keyframe = *map_.findKeyframe(match.keyframe_id);
      const SE3 T_cur_ref = frame_.T_cam_world * keyframe.T_cam_world.inverse();
      m.x = triangulateInverseDistance(map_.camera, T_cur_ref, seed->anchor.f, feature->anchor.px);
      m.tau = inverseDistanceSigma(
          T_cur_ref, seed->anchor.f, m.x,
          std::max(parameters_.mapping.search.pixel_noise, frame_.noise_px), map_.camera.focal());
      const bool parallax = parallaxAt(T_cur_ref, seed->anchor.f, seed->belief.mu) >
                            parameters_.mapping.search.min_parallax_deg * kDegree;
      // Without a baseline the sign of x is chance, and no evidence against the seed.
      if (feature->status != FeatureStatus::inlier)
        m.outcome = SearchOutcome::no_match;
      else if (!parallax)
        m.outcome = SearchOutcome::low_parallax;
      else if (!(m.x > 0))
        m.outcome = SearchOutcome::no_match;
    }
    const double fused = fusedInverseDistance(seed->belief, m.x, m.tau);
    record_.seeds_converged += measureSeed(*seed, m);
    record_.seed_updates += m.outcome == SearchOutcome::tracked;
    record_.seeds_rejected += seed->status == SeedStatus::rejected;
    if (feature) {
      const Keyframe& keyframe = *map_.findKeyframe(match.keyframe_id);
      const bool doubtful =
          seed->status == SeedStatus::active && m.outcome == SearchOutcome::tracked && fused > 0;
      // The pose confirmed the match: until the filter has made up its mind, the match counts.
      feature->p_world = doubtful ? Vec3(keyframe.T_cam_world.inverse() * (seed->anchor.f / fused))
                                  : seedPoint(*seed, keyframe);
    }
    if (feature && seed->status == SeedStatus::rejected) feature->status = FeatureStatus::outlier;
  }
  std::sort(measured_seeds_.begin(), measured_seeds_.end());
}

void Tracker::requestSeeds(const Keyframe& keyframe) {
  job_.emplace();
  job_->new_seeds.wanted = true;
  job_->new_seeds.keyframe_id = keyframe.id;
  job_->new_seeds.occupied =
      occupied_.withCells(scaledCell(parameters_.mapping.detector.cell_px, map_.camera.width));
  job_->new_seeds.median_depth = keyframe.median_depth;
  job_->new_seeds.min_depth = keyframe.min_depth;
  job_->new_seeds.scale = keyframe.scale;
  if (last_.pyramid)
    job_->older_views.push_back({-1, last_.pyramid, last_.T_cam_world, last_.index});
  for (const int id : local_keyframes_) {
    if (job_->older_views.size() >= kOlderViews) break;
    const Keyframe& k = *map_.findKeyframe(id);
    if (id != keyframe.id && k.frame_index != last_.index)
      job_->older_views.push_back({id, k.pyramid, k.T_cam_world, k.frame_index});
  }
}

void Tracker::requestMeasurements() {
  if (!job_) job_.emplace();
  job_->frame_index = frame_.index;
  job_->pyramid = frame_.pyramid;
  job_->T_cam_world = frame_.T_cam_world;
  job_->camera = map_.camera;
  job_->noise_px = frame_.noise_px;
  requestSegmentMeasurements();
  requestAdjustment();
  for (const int id : local_keyframes_) {
    const Keyframe* keyframe = map_.findKeyframe(id);
    if (!keyframe || keyframe->frame_index == frame_.index) continue;
    const int slot = static_cast<int>(job_->keyframes.size());
    job_->keyframes.push_back(
        {id, keyframe->pyramid, keyframe->T_cam_world, keyframe->frame_index, keyframe->scale});
    for (const Seed& seed : keyframe->seeds) {
      if (!alive(seed)) continue;
      if (job_->seeds.size() >= kMostJobSeeds) return;
      if (std::binary_search(measured_seeds_.begin(), measured_seeds_.end(), seed.id)) continue;
      const Vec3 p = frame_.T_cam_world * seedPoint(seed, *keyframe);
      if (p.z() < 1e-3 || !map_.camera.inside(map_.camera.project(p), 8)) continue;
      job_->seeds.push_back(
          {seed.id, slot, seed.anchor, seed.belief.mu, std::sqrt(seed.belief.sigma2)});
    }
  }
}

std::optional<MappingJob> Tracker::takeMappingJob() {
  std::optional<MappingJob> job = std::move(job_);
  job_.reset();
  return job;
}

/// Inverse distances of the answer are in the scale their keyframes had when the job was made.
void Tracker::bringToScale(MappingResult& result) const {
  std::map<int, double> factors;
  for (const JobScale& then : result.scales) {
    const Keyframe* keyframe = map_.findKeyframe(then.keyframe_id);
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

void Tracker::applyMapping(MappingResult result) {
  bringToScale(result);
  record_.time_ms[static_cast<int>(Stage::mapping)] += result.time_ms;
  for (const SeedMeasurement& m : result.measurements) {
    Seed* seed = map_.findSeed(m.keyframe_id, m.seed_id);
    if (!seed || !alive(*seed)) continue;
    record_.seeds_converged += measureSeed(*seed, m);
    record_.seed_updates += m.outcome == SearchOutcome::matched;
    record_.seeds_rejected += seed->status == SeedStatus::rejected;
  }
  applySegmentMapping(result);
  Keyframe* keyframe = map_.findKeyframe(result.keyframe_id);
  if (keyframe) addSeeds(*keyframe, result);
  // Last: it changes the scale of what was measured before.
  applyAdjustment(result.adjustment);
  record_.seeds = map_.seedCount();
}

void Tracker::addSeeds(Keyframe& keyframe, const MappingResult& result) {
  for (const NewSeed& fresh : result.new_seeds) {
    Seed seed = makeSeed(fresh.feature, map_.camera, result.median_depth, result.min_depth,
                         parameters_.mapping.filter);
    seed.id = map_.next_id++;
    seed.keyframe_id = keyframe.id;
    for (const SeedMeasurement& m : fresh.measurements) {
      measureSeed(seed, m);
      ++record_.seed_updates;
    }
    keyframe.seeds.push_back(seed);
  }
}

}  // namespace svoscope
