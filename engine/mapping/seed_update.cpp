// SPDX-License-Identifier: MIT
#include "engine/mapping/seed_update.h"

#include <algorithm>
#include <cmath>

#include "engine/base/stopwatch.h"
#include "engine/mapping/segment_seed_update.h"

namespace svoscope {

namespace {

EpipolarMatch measure(const FeatureAnchor& anchor, double mu, double sigma,
                      const JobKeyframe& owner, const PyramidPtr& pyramid, const SE3& T_cam_world,
                      const Pinhole& camera, const MappingParameters& p) {
  EpipolarQuery q;
  q.ref = owner.pyramid.get();
  q.cur = pyramid.get();
  q.camera = camera;
  q.T_cur_ref = T_cam_world * owner.T_cam_world.inverse();
  q.px_ref = anchor.px;
  q.f_ref = anchor.f;
  q.level_ref = anchor.level;
  q.type = anchor.type;
  q.gradient_dir = anchor.gradient_dir;
  q.mu = mu;
  q.sigma = sigma;
  return searchEpipolar(q, p.search, p.alignment);
}

SeedMeasurement toMeasurement(const EpipolarMatch& match, std::int64_t seed_id, int keyframe_id,
                              int frame_index) {
  // Without a scan the search reports no score.
  return {seed_id,   keyframe_id, frame_index, match.outcome, match.inv_distance,
          match.tau, match.px,    match.score};
}

/// New seeds are measured at once against older views: forward motion needs it.
void measureAgainstOlder(const MappingJob& job, const MappingParameters& p, Seed seed,
                         NewSeed& out) {
  const JobKeyframe self{job.new_seeds.keyframe_id, job.pyramid, job.T_cam_world, job.frame_index};
  seed.has_shadow = false;  // only the rule in use leads the searches
  for (const JobKeyframe& view : job.older_views) {
    const EpipolarMatch match = measure(seed.anchor, seed.belief.mu, std::sqrt(seed.belief.sigma2),
                                        self, view.pyramid, view.T_cam_world, job.camera, p);
    // That an old view does not show the feature says nothing against it.
    if (match.outcome != SearchOutcome::matched) continue;
    const SeedMeasurement m = toMeasurement(match, -1, self.id, view.frame_index);
    applyMeasurement(seed, m, p.filter);
    out.measurements.push_back(m);
  }
}

}  // namespace

Seed makeSeed(const DetectedFeature& feature, const Pinhole& camera, double median_depth,
              double min_depth, const DepthFilterParameters& p) {
  Seed seed;
  seed.anchor = {feature.px, camera.bearing(feature.px), feature.level, feature.type,
                 feature.gradient_dir};
  seed.score = feature.score;
  seed.range = 1.0 / (0.5 * min_depth);
  seed.belief.mu = 1.0 / median_depth;
  const double sigma = seed.range * p.initial_sigma_fraction;
  seed.belief.sigma2 = sigma * sigma;
  seed.belief.a = seed.belief.b = p.initial_ab;
  seed.shadow.fill(seed.belief);
  return seed;
}

namespace {

void updateBeliefs(Seed& seed, const SeedMeasurement& m, const DepthFilterParameters& p) {
  const Measurement measured{m.x, m.tau * m.tau, seed.range};
  seed.belief = updateBelief(p.rule, seed.belief, measured, p.rules);
  if (!seed.has_shadow) return;
  for (const FilterRule rule : kRules) {
    if (rule == p.rule) continue;
    seed.shadow[rule] = updateBelief(rule, seed.shadow[rule], measured, p.rules);
  }
}

}  // namespace

void applyMeasurement(Seed& seed, const SeedMeasurement& m, const DepthFilterParameters& p) {
  switch (noteSearch(seed, m.outcome, m.frame_index)) {
    case Evidence::measured:
      seed.has_shadow = seed.has_shadow && p.shadow;
      updateBeliefs(seed, m, p);
      seed.last_x = m.x;
      seed.last_tau = m.tau;
      break;
    case Evidence::missed:
      seed.belief.b += 1;
      for (Belief& shadow : seed.shadow) shadow.b += 1;
      break;
    case Evidence::none:
      return;
  }
  judge(seed, &seed.belief, 1, p);
}

MappingResult runMappingJob(const MappingJob& job, const MappingParameters& parameters) {
  Stopwatch watch;
  MappingParameters p = parameters;
  p.search.pixel_noise = std::max(p.search.pixel_noise, job.noise_px);
  MappingResult result;
  result.frame_index = job.frame_index;
  result.keyframe_id = job.new_seeds.keyframe_id;
  result.median_depth = job.new_seeds.median_depth;
  result.min_depth = job.new_seeds.min_depth;
  for (const JobKeyframe& k : job.keyframes) result.scales.push_back({k.id, k.scale});
  if (job.new_seeds.wanted)
    result.scales.push_back({job.new_seeds.keyframe_id, job.new_seeds.scale});
  result.measurements.reserve(job.seeds.size());
  for (const JobSeed& seed : job.seeds) {
    const JobKeyframe& owner = job.keyframes[seed.keyframe_slot];
    const EpipolarMatch match = measure(seed.anchor, seed.mu, seed.sigma, owner, job.pyramid,
                                        job.T_cam_world, job.camera, p);
    result.measurements.push_back(toMeasurement(match, seed.id, owner.id, job.frame_index));
  }
  if (job.new_seeds.wanted) {
    for (const DetectedFeature& f :
         detectFeatures(*job.pyramid, p.detector, job.new_seeds.occupied)) {
      if (static_cast<int>(result.new_seeds.size()) >= p.filter.max_seeds_per_keyframe) break;
      NewSeed fresh{f, {}};
      measureAgainstOlder(
          job, p, makeSeed(f, job.camera, result.median_depth, result.min_depth, p.filter), fresh);
      result.new_seeds.push_back(std::move(fresh));
    }
  }
  result.segments = runSegmentJob(job, p);
  if (!job.adjustment.empty()) result.adjustment = adjustLocally(job.adjustment, p.local_ba);
  result.time_ms = watch.ms();
  return result;
}

}  // namespace svoscope
