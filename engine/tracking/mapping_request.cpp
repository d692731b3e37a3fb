// SPDX-License-Identifier: MIT
#include "engine/tracking/mapping_request.h"

#include <algorithm>
#include <cmath>

namespace svoscope {

namespace {

constexpr std::size_t kMostJobSeeds = 800;
constexpr std::size_t kOlderViews = 3;

void requestSeeds(const MappingRequest& r, const DetectorParameters& p, MappingJob& job) {
  const Keyframe& keyframe = *r.new_keyframe;
  job.new_seeds.wanted = true;
  job.new_seeds.keyframe_id = keyframe.id;
  job.new_seeds.occupied = r.occupied.withCells(scaledCell(p.cell_px, r.map.camera.width));
  job.new_seeds.median_depth = keyframe.median_depth;
  job.new_seeds.min_depth = keyframe.min_depth;
  job.new_seeds.scale = keyframe.scale;
  if (r.last.pyramid)
    job.older_views.push_back({-1, r.last.pyramid, r.last.T_cam_world, r.last.index});
  for (const int id : r.local_keyframes) {
    if (job.older_views.size() >= kOlderViews) break;
    const Keyframe& k = *r.map.findKeyframe(id);
    if (id != keyframe.id && k.frame_index != r.last.index)
      job.older_views.push_back({id, k.pyramid, k.T_cam_world, k.frame_index});
  }
}

JobKeyframe copyOf(const Keyframe& k) {
  return {k.id, k.pyramid, k.T_cam_world, k.frame_index, k.scale};
}

JobSegmentSeed wishFor(const SegmentSeed& seed, int slot) {
  JobSegmentSeed wish{seed.id, slot, seed.anchor, {}, {}};
  for (int i = 0; i < 2; ++i) {
    wish.mu[i] = seed.belief[i].mu;
    wish.sigma[i] = std::sqrt(seed.belief[i].sigma2);
  }
  return wish;
}

void requestSegments(const MappingRequest& r, const SegmentParameters& p, MappingJob& job) {
  std::vector<std::int64_t> measured;
  for (const TrackedSegment& s : r.frame.segments) {
    if (job.new_seeds.wanted && s.status == FeatureStatus::inlier)
      job.segments.tracked.push_back({{s.anchor.px[0], s.anchor.px[1]}});
    if (s.origin != FeatureOrigin::landmark) measured.push_back(s.id);
  }
  for (const int id : r.local_keyframes) {
    const Keyframe* keyframe = r.map.findKeyframe(id);
    if (!keyframe || keyframe->frame_index == r.frame.index || keyframe->segment_seeds.empty())
      continue;
    const int slot = static_cast<int>(job.keyframes.size());
    job.keyframes.push_back(copyOf(*keyframe));
    for (const SegmentSeed& seed : keyframe->segment_seeds) {
      if (!alive(seed) || std::find(measured.begin(), measured.end(), seed.id) != measured.end())
        continue;
      if (static_cast<int>(job.segments.seeds.size()) >= p.max_job_seeds) return;
      job.segments.seeds.push_back(wishFor(seed, slot));
    }
  }
}

void requestPoints(const MappingRequest& r, MappingJob& job) {
  for (const int id : r.local_keyframes) {
    const Keyframe* keyframe = r.map.findKeyframe(id);
    if (!keyframe || keyframe->frame_index == r.frame.index) continue;
    const int slot = static_cast<int>(job.keyframes.size());
    job.keyframes.push_back(copyOf(*keyframe));
    for (const Seed& seed : keyframe->seeds) {
      if (!alive(seed)) continue;
      if (job.seeds.size() >= kMostJobSeeds) return;
      if (std::binary_search(r.measured.begin(), r.measured.end(), seed.id)) continue;
      const Vec3 p = r.frame.T_cam_world * seedPoint(seed, *keyframe);
      if (p.z() < 1e-3 || !r.map.camera.inside(r.map.camera.project(p), 8)) continue;
      job.seeds.push_back(
          {seed.id, slot, seed.anchor, seed.belief.mu, std::sqrt(seed.belief.sigma2)});
    }
  }
}

}  // namespace

MappingJob makeMappingJob(const MappingRequest& r, const MappingParameters& p) {
  MappingJob job;
  job.frame_index = r.frame.index;
  job.pyramid = r.frame.pyramid;
  job.T_cam_world = r.frame.T_cam_world;
  job.camera = r.map.camera;
  job.noise_px = r.frame.noise_px;
  if (r.new_keyframe) requestSeeds(r, p.detector, job);
  if (p.segments.enabled) requestSegments(r, p.segments, job);
  requestPoints(r, job);
  return job;
}

}  // namespace svoscope
