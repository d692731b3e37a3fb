// SPDX-License-Identifier: MIT
// How the tracker changes the map: seeds, landmarks, keyframes, and jobs for the mapping thread.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/quantile.h"
#include "engine/mapping/landmark_refinement.h"
#include "engine/tracking/tracker.h"

namespace svoscope {

namespace {

constexpr std::size_t kMostJobSeeds = 800;
constexpr std::size_t kOlderViews = 3;
constexpr int kSeedMemoryFrames = 60;
constexpr double kDegree = M_PI / 180.0;

}  // namespace

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

Seed* Tracker::findSeed(int keyframe_id, std::int64_t id) {
  Keyframe* keyframe = map_.findKeyframe(keyframe_id);
  if (!keyframe) return nullptr;
  auto& seeds = keyframe->seeds;  // in order of id
  const auto it = std::lower_bound(seeds.begin(), seeds.end(), id,
                                   [](const Seed& s, std::int64_t value) { return s.id < value; });
  return it != seeds.end() && it->id == id ? &*it : nullptr;
}

/// Ended seeds stay for one frame, so that its snapshot shows how they ended. Keyframes long out of
/// sight lose theirs: the cost of a frame must not grow with the path.
void Tracker::dropEndedSeeds() {
  for (const int id : local_keyframes_) {
    if (Keyframe* keyframe = map_.findKeyframe(id)) keyframe->last_local_frame = frame_.index;
  }
  map_.orphans.clear();
  for (auto& [id, keyframe] : map_.keyframes) {
    auto& seeds = keyframe.seeds;
    if (frame_.index - std::max(keyframe.last_local_frame, keyframe.frame_index) > kSeedMemoryFrames)
      map_.endSeeds(keyframe, SeedEnding::out_of_sight);
    seeds.erase(std::remove_if(seeds.begin(), seeds.end(),
                               [](const Seed& s) {
                                 return s.status == SeedStatus::rejected || s.status == SeedStatus::promoted;
                               }),
                seeds.end());
    for (Seed& seed : seeds) seed.outcome = SearchOutcome::none;
  }
  dropEndedSegmentSeeds();
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
    Seed* seed = findSeed(match.keyframe_id, match.seed_id);
    if (!seed) continue;
    measured_seeds_.push_back(match.seed_id);
    SeedMeasurement m{match.seed_id, match.keyframe_id, frame_.index, match.outcome};
    m.score = match.score;
    TrackedFeature* feature = match.feature < 0 ? nullptr : &frame_.features[static_cast<std::size_t>(match.feature)];
    if (feature) {
      m.px = feature->anchor.px;
      const Keyframe& keyframe = *map_.findKeyframe(match.keyframe_id);
      const SE3 T_cur_ref = frame_.T_cam_world * keyframe.T_cam_world.inverse();
      m.x = triangulateInverseDistance(map_.camera, T_cur_ref, seed->anchor.f, feature->anchor.px);
      m.tau = inverseDistanceSigma(T_cur_ref, seed->anchor.f, m.x,
                                   std::max(parameters_.mapping.search.pixel_noise, frame_.noise_px), map_.camera.focal());
      if (feature->status != FeatureStatus::inlier || !(m.x > 0)) m.outcome = SearchOutcome::no_match;
    }
    const double fused = fusedInverseDistance(seed->belief, m.x, m.tau);
    record_.seeds_converged += measureSeed(*seed, m);
    record_.seed_updates += m.outcome == SearchOutcome::tracked;
    record_.seeds_rejected += seed->status == SeedStatus::rejected;
    if (feature) {
      const Keyframe& keyframe = *map_.findKeyframe(match.keyframe_id);
      const bool doubtful = seed->status == SeedStatus::active && m.outcome == SearchOutcome::tracked && fused > 0;
      // The pose confirmed the match: until the filter has made up its mind, the match counts.
      feature->p_world = doubtful ? Vec3(keyframe.T_cam_world.inverse() * (seed->anchor.f / fused)) : seedPoint(*seed, keyframe);
    }
    if (feature && seed->status == SeedStatus::rejected) feature->status = FeatureStatus::outlier;
  }
  std::sort(measured_seeds_.begin(), measured_seeds_.end());
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
  Seed* seed = findSeed(f.keyframe_id, f.id);
  if (!seed) return;
  seed->status = SeedStatus::promoted;
  seed->ending = SeedEnding::promoted;
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
  if (!parameters_.mapping.local_ba.enabled) return;
  job_->adjustment = localProblem(map_, id, parameters_.mapping.local_ba, parameters_.mapping.segments);
  job_->adjustment.timed = timed_;
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
    for (TrackedFeature& f : frame_.features) {
      // What the removal took from the map must not be used for the next alignment's bookkeeping.
      if (f.origin == FeatureOrigin::landmark ? !map_.find(f.id) : f.keyframe_id == farthest)
        f.status = FeatureStatus::outlier;
    }
    disownSegments(farthest);
    local_keyframes_.erase(std::remove(local_keyframes_.begin(), local_keyframes_.end(), farthest), local_keyframes_.end());
  }
}

void Tracker::requestSeeds(const Keyframe& keyframe) {
  job_.emplace();
  job_->new_seeds.wanted = true;
  job_->new_seeds.keyframe_id = keyframe.id;
  job_->new_seeds.occupied = occupied_;
  job_->new_seeds.median_depth = keyframe.median_depth;
  job_->new_seeds.min_depth = keyframe.min_depth;
  if (last_.pyramid) job_->older_views.push_back({-1, last_.pyramid, last_.T_cam_world, last_.index});
  for (const int id : local_keyframes_) {
    if (job_->older_views.size() >= kOlderViews) break;
    const Keyframe& k = *map_.findKeyframe(id);
    if (id != keyframe.id && k.frame_index != last_.index) job_->older_views.push_back({id, k.pyramid, k.T_cam_world, k.frame_index});
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
  for (const int id : local_keyframes_) {
    const Keyframe* keyframe = map_.findKeyframe(id);
    if (!keyframe || keyframe->frame_index == frame_.index) continue;
    const int slot = static_cast<int>(job_->keyframes.size());
    job_->keyframes.push_back({id, keyframe->pyramid, keyframe->T_cam_world, keyframe->frame_index});
    for (const Seed& seed : keyframe->seeds) {
      if (seed.status != SeedStatus::active && seed.status != SeedStatus::converged) continue;
      if (job_->seeds.size() >= kMostJobSeeds) return;
      if (std::binary_search(measured_seeds_.begin(), measured_seeds_.end(), seed.id)) continue;
      const Vec3 p = frame_.T_cam_world * seedPoint(seed, *keyframe);
      if (p.z() < 1e-3 || !map_.camera.inside(map_.camera.project(p), 8)) continue;
      job_->seeds.push_back({seed.id, slot, seed.anchor, seed.belief.mu, std::sqrt(seed.belief.sigma2)});
    }
  }
}

std::optional<MappingJob> Tracker::takeMappingJob() {
  std::optional<MappingJob> job = std::move(job_);
  job_.reset();
  return job;
}

void Tracker::applyMapping(const MappingResult& result) {
  record_.time_ms[static_cast<int>(Stage::mapping)] += result.time_ms;
  for (const SeedMeasurement& m : result.measurements) {
    Seed* seed = findSeed(m.keyframe_id, m.seed_id);
    if (!seed || seed->status == SeedStatus::rejected || seed->status == SeedStatus::promoted) continue;
    record_.seeds_converged += measureSeed(*seed, m);
    record_.seed_updates += m.outcome == SearchOutcome::matched;
    record_.seeds_rejected += seed->status == SeedStatus::rejected;
  }
  applyAdjustment(result.adjustment);
  applySegmentMapping(result);
  Keyframe* keyframe = map_.findKeyframe(result.keyframe_id);
  if (!keyframe) return;
  for (const NewSeed& fresh : result.new_seeds) {
    Seed seed = makeSeed(fresh.feature, map_.camera, result.median_depth, result.min_depth, parameters_.mapping.filter);
    seed.id = map_.next_id++;
    seed.keyframe_id = keyframe->id;
    for (const SeedMeasurement& m : fresh.measurements) {
      measureSeed(seed, m);
      ++record_.seed_updates;
    }
    keyframe->seeds.push_back(seed);
  }
  record_.seeds = map_.seedCount();
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
    const FeatureAnchor anchor{p.px_ref, map_.camera.bearing(p.px_ref), p.level, p.type, p.gradient_dir};
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
