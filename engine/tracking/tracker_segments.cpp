// SPDX-License-Identifier: MIT
// Segments in the tracker: the same steps as for points, in the same order.
#include <algorithm>
#include <cmath>

#include "engine/base/angle.h"
#include "engine/mapping/segment_refinement.h"
#include "engine/mapping/segment_seed_update.h"
#include "engine/tracking/tracker.h"
#include "engine/tracking/tracker_attempt.h"

namespace svoscope {

namespace {

/// Sigma of the inverse distance over its mean, the worse of both ends.
double relativeSigma(const SegmentSeed& s) {
  double worst = 0;
  for (const Belief& b : s.belief)
    worst = std::max(worst, std::sqrt(b.sigma2) / std::max(b.mu, 1e-9));
  return worst;
}

void setSeedPose(const SegmentSeed& seed, const Keyframe& keyframe, TrackedSegment& s) {
  const SE3 T_world_kf = keyframe.T_cam_world.inverse();
  for (int i = 0; i < 2; ++i) {
    s.p_world[i] = T_world_kf * (seed.anchor.f[i] / seed.belief[i].mu);
    s.covariance[i] = seedEndCovariance(seed, i, keyframe.T_cam_world);
  }
}

}  // namespace

std::vector<AlignmentPatch> Tracker::alignmentPatches() const {
  std::vector<AlignmentPatch> patches;
  patches.reserve(last_.features.size());
  for (const TrackedFeature& f : last_.features) {
    if (f.status != FeatureStatus::inlier) continue;
    const Vec3 p = last_.T_cam_world * f.p_world;
    if (p.z() > 0) patches.push_back({f.anchor.px, f.anchor.f * p.norm()});
  }
  appendSegmentPatches(map_.camera, last_, parameters_.mapping.segments, patches);
  return patches;
}

void Tracker::acceptSegments(Attempt& a) {
  for (std::size_t i = 0; i < a.segments.segments.size(); ++i) {
    TrackedSegment& s = a.segments.segments[i];
    s.error_px = a.pose.segment_error_px[i];
    s.status = a.pose.segment_inlier[i] ? FeatureStatus::inlier : FeatureStatus::outlier;
  }
  frame_.segments = a.segments.segments;
}

/// The measured lines enter the filter with the final pose.
void Tracker::commitSegments() {
  for (TrackedSegment& s : frame_.segments) {
    SegmentSeed* seed =
        s.origin == FeatureOrigin::landmark ? nullptr : map_.findSegmentSeed(s.keyframe_id, s.id);
    if (!seed) continue;
    const Keyframe& keyframe = *map_.findKeyframe(s.keyframe_id);
    const SE3 T_cur_ref = frame_.T_cam_world * keyframe.T_cam_world.inverse();
    SegmentMeasurement m =
        measureFromLine(map_.camera, T_cur_ref, seed->anchor, s.anchor.px, parameters_.mapping);
    m.frame_index = frame_.index;
    for (int i = 0; i < 2; ++i) {
      const double parallax = parallaxAt(T_cur_ref, seed->anchor.f[i], seed->belief[i].mu);
      if (parallax < parameters_.mapping.search.min_parallax_deg * kDegree)
        m.outcome = SearchOutcome::low_parallax;
    }
    if (s.status != FeatureStatus::inlier) m.outcome = SearchOutcome::no_match;
    const SeedStatus before = seed->status;
    applySegmentMeasurement(*seed, m, parameters_.mapping.filter);
    record_.segment_updates += m.outcome == SearchOutcome::tracked;
    record_.seeds_converged +=
        seed->status == SeedStatus::converged && before == SeedStatus::active;
    record_.seeds_rejected += seed->status == SeedStatus::rejected;
    setSeedPose(*seed, keyframe, s);
    if (seed->status == SeedStatus::rejected) s.status = FeatureStatus::outlier;
  }
}

/// Every landmark in view gets the new line; a seed whose depth is known becomes a landmark.
void Tracker::promoteSegments(Keyframe& keyframe) {
  for (TrackedSegment& s : frame_.segments) {
    if (s.status != FeatureStatus::inlier) continue;
    if (s.origin == FeatureOrigin::landmark) {
      const auto it = map_.segments.find(s.id);
      if (it == map_.segments.end()) continue;
      it->second.views.push_back({keyframe.id, s.anchor});
      keyframe.segments.push_back(s.id);
      continue;
    }
    SegmentSeed* seed = map_.findSegmentSeed(s.keyframe_id, s.id);
    if (!seed || seed->keyframe_id == keyframe.id ||
        relativeSigma(*seed) > parameters_.mapping.segments.promote_sigma ||
        seed->belief[0].inlierRatio() < parameters_.mapping.filter.min_inlier_ratio)
      continue;
    endSeed(*seed, SeedEnding::promoted);
    SegmentLandmark landmark;
    landmark.id = map_.next_id++;
    for (int i = 0; i < 2; ++i) {
      landmark.p_world[i] = s.p_world[i];
      landmark.covariance[i] = s.covariance[i];
      landmark.prior[i] = seed->belief[i].mu;
      landmark.prior_sigma[i] = std::sqrt(seed->belief[i].sigma2);
    }
    landmark.views = {{seed->keyframe_id, seed->anchor}, {keyframe.id, s.anchor}};
    map_.findKeyframe(seed->keyframe_id)->segments.push_back(landmark.id);
    keyframe.segments.push_back(landmark.id);
    s.origin = FeatureOrigin::landmark;
    s.id = landmark.id;
    map_.segments.emplace(landmark.id, std::move(landmark));
  }
}

void Tracker::refineSegments() {
  for (TrackedSegment& s : frame_.segments) {
    if (s.origin != FeatureOrigin::landmark || s.status != FeatureStatus::inlier) continue;
    const auto it = map_.segments.find(s.id);
    if (it == map_.segments.end()) continue;
    refineSegment(it->second, map_, parameters_.mapping.segments.line_noise_px,
                  parameters_.quality.structure_iterations);
    for (int i = 0; i < 2; ++i) {
      s.p_world[i] = it->second.p_world[i];
      s.covariance[i] = it->second.covariance[i];
    }
  }
}

void Tracker::requestSegmentMeasurements() {
  const SegmentParameters& p = parameters_.mapping.segments;
  if (!p.enabled) return;
  if (job_->new_seeds.wanted) {
    for (const TrackedSegment& s : frame_.segments) {
      if (s.status == FeatureStatus::inlier)
        job_->segments.tracked.push_back({{s.anchor.px[0], s.anchor.px[1]}});
    }
  }
  std::vector<std::int64_t> measured;
  for (const TrackedSegment& s : frame_.segments) {
    if (s.origin != FeatureOrigin::landmark) measured.push_back(s.id);
  }
  for (const int id : local_keyframes_) {
    const Keyframe* keyframe = map_.findKeyframe(id);
    if (!keyframe || keyframe->frame_index == frame_.index || keyframe->segment_seeds.empty())
      continue;
    auto& keyframes = job_->keyframes;
    auto slot = std::find_if(keyframes.begin(), keyframes.end(),
                             [id](const JobKeyframe& k) { return k.id == id; });
    if (slot == keyframes.end())
      slot = keyframes.insert(slot, {id, keyframe->pyramid, keyframe->T_cam_world,
                                     keyframe->frame_index, keyframe->scale});
    for (const SegmentSeed& seed : keyframe->segment_seeds) {
      if (!alive(seed) || std::find(measured.begin(), measured.end(), seed.id) != measured.end())
        continue;
      if (static_cast<int>(job_->segments.seeds.size()) >= p.max_job_seeds) return;
      JobSegmentSeed wish{seed.id, static_cast<int>(slot - keyframes.begin()), seed.anchor, {}, {}};
      for (int i = 0; i < 2; ++i) {
        wish.mu[i] = seed.belief[i].mu;
        wish.sigma[i] = std::sqrt(seed.belief[i].sigma2);
      }
      job_->segments.seeds.push_back(wish);
    }
  }
}

void Tracker::applySegmentMapping(const MappingResult& result) {
  const DepthFilterParameters& filter = parameters_.mapping.filter;
  for (const SegmentMeasurement& m : result.segments.measurements) {
    SegmentSeed* seed = map_.findSegmentSeed(m.keyframe_id, m.seed_id);
    if (!seed || !alive(*seed)) continue;
    const SeedStatus before = seed->status;
    applySegmentMeasurement(*seed, m, filter);
    record_.segment_updates += m.outcome == SearchOutcome::matched;
    record_.seeds_converged +=
        seed->status == SeedStatus::converged && before == SeedStatus::active;
    record_.seeds_rejected += seed->status == SeedStatus::rejected;
  }
  Keyframe* keyframe = map_.findKeyframe(result.keyframe_id);
  if (!keyframe) return;
  for (const NewSegmentSeed& fresh : result.segments.new_seeds) {
    SegmentSeed seed = makeSegmentSeed(fresh.anchor, result.median_depth, result.min_depth, filter);
    seed.id = map_.next_id++;
    seed.keyframe_id = keyframe->id;
    for (const SegmentMeasurement& m : fresh.measurements) applySegmentMeasurement(seed, m, filter);
    record_.segment_updates += static_cast<int>(fresh.measurements.size());
    keyframe->segment_seeds.push_back(seed);
  }
}

/// The frame's segments take the places of their landmarks and seeds after an adjustment.
void Tracker::followSegments() {
  for (TrackedSegment& s : frame_.segments) {
    const auto it = map_.segments.find(s.id);
    if (s.origin == FeatureOrigin::landmark && it != map_.segments.end()) {
      for (int i = 0; i < 2; ++i) s.p_world[i] = it->second.p_world[i];
    } else if (const SegmentSeed* seed = map_.findSegmentSeed(s.keyframe_id, s.id)) {
      setSeedPose(*seed, *map_.findKeyframe(s.keyframe_id), s);
    }
  }
}

void Tracker::disownSegments(int keyframe_id) {
  for (TrackedSegment& s : frame_.segments) {
    const bool gone = s.origin == FeatureOrigin::landmark ? !map_.segments.count(s.id)
                                                          : s.keyframe_id == keyframe_id;
    if (gone) s.status = FeatureStatus::outlier;
  }
}

}  // namespace svoscope
