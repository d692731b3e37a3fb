// SPDX-License-Identifier: MIT
#include "engine/runner/snapshot_builder.h"

#include <algorithm>
#include <cmath>

#include "engine/runner/segment_views.h"

namespace svoscope {

namespace {

FeatureView featureView(const TrackedFeature& f, const Tracker& tracker) {
  FeatureView v;
  const Frame& frame = tracker.frame();
  v.id = f.id;
  v.type = f.anchor.type;
  v.origin = f.origin;
  v.status = f.status;
  v.level = static_cast<std::uint8_t>(f.anchor.level);
  const Vec3 p = frame.T_cam_world * f.p_world;
  v.predicted_px = f.predicted_px.cast<float>();
  if (p.z() > 1e-6 && f.status != FeatureStatus::not_aligned)
    v.predicted_px = tracker.map().camera.project(p).cast<float>();
  v.px = f.status == FeatureStatus::not_aligned ? v.predicted_px : f.anchor.px.cast<float>();
  v.direction = static_cast<float>(std::atan2(f.anchor.gradient_dir.y(), f.anchor.gradient_dir.x()));
  v.depth = static_cast<float>(p.z());
  v.residual_px = static_cast<float>(f.error_px);
  v.reference_keyframe = f.keyframe_id;
  if (f.origin == FeatureOrigin::landmark) {
    if (const Landmark* landmark = tracker.map().find(f.id))
      v.observations = static_cast<int>(landmark->observations.size());
  }
  return v;
}

FeatureView trackView(const InitializerTrack& t) {
  FeatureView v;
  v.id = t.id;
  v.type = t.type;
  v.origin = FeatureOrigin::track;
  v.px = t.px_cur.cast<float>();
  v.predicted_px = t.px_ref.cast<float>();
  return v;
}

/// What a seed is and believes, without where that is.
SeedView seedState(const Seed& seed, FilterRule rule) {
  SeedView v;
  v.id = seed.id;
  v.keyframe_id = seed.keyframe_id;
  v.type = seed.anchor.type;
  v.status = seed.status;
  v.ending = seed.ending;
  v.outcome = seed.outcome;
  v.level = static_cast<std::uint8_t>(seed.anchor.level);
  v.px_ref = seed.anchor.px.cast<float>();
  v.direction = static_cast<float>(std::atan2(seed.anchor.gradient_dir.y(), seed.anchor.gradient_dir.x()));
  v.mu = static_cast<float>(seed.belief.mu);
  v.sigma = static_cast<float>(std::sqrt(seed.belief.sigma2));
  v.a = static_cast<float>(seed.belief.a);
  v.b = static_cast<float>(seed.belief.b);
  v.kl = beliefView(seed, FilterRule::kl, rule);
  v.js = beliefView(seed, FilterRule::js, rule);
  v.range = static_cast<float>(seed.range);
  v.updates = seed.updates;
  v.failures = seed.failures;
  v.last_x = static_cast<float>(seed.last_x);
  v.last_tau = static_cast<float>(seed.last_tau);
  return v;
}

SeedView seedView(const Seed& seed, const Tracker& tracker, const SE3& T_world_kf, const cv::Mat& depth) {
  SeedView v = seedState(seed, tracker.parameters().mapping.filter.rule);
  const double mu = seed.belief.mu, sigma = std::sqrt(seed.belief.sigma2);
  const double n = tracker.parameters().mapping.search.search_sigmas;
  const double z[3] = {mu, mu + n * sigma, std::max(mu - n * sigma, 0.05 * mu)};
  const Pinhole& camera = tracker.map().camera;
  Vec2f px[3];
  Vec3f world[3];
  bool front = true;
  for (int i = 0; i < 3; ++i) {
    const Vec3 p = T_world_kf * (seed.anchor.f / std::max(z[i], 1e-6));
    world[i] = p.cast<float>();
    const Vec3 c = tracker.frame().T_cam_world * p;
    front = front && c.z() > 1e-3;
    px[i] = front ? Vec2f(camera.project(c).cast<float>()) : px[0];
  }
  v.visible = front && camera.inside(px[0].cast<double>(), 0);
  v.px = px[0];
  v.px_near = px[1];
  v.px_far = px[2];
  v.position = world[0];
  v.position_near = world[1];
  v.position_far = world[2];
  const int x = static_cast<int>(std::lround(seed.anchor.px.x())), y = static_cast<int>(std::lround(seed.anchor.px.y()));
  if (!depth.empty() && x >= 0 && y >= 0 && x < depth.cols && y < depth.rows) {
    // Depth images hold z; seeds measure along the ray.
    const float true_z = depth.at<float>(y, x);
    if (true_z > 0) v.true_inv_distance = static_cast<float>(seed.anchor.f.z()) / true_z;
  }
  return v;
}

}  // namespace

void SnapshotBuilder::reset() {
  depths_.clear();
  keyframes_.reset();
  points_.reset();
}

const cv::Mat& SnapshotBuilder::depthOf(const Keyframe& keyframe) {
  const auto it = depths_.find(keyframe.id);
  if (it != depths_.end()) return it->second;
  return depths_[keyframe.id] = read_depth_ ? read_depth_(keyframe.frame_index) : cv::Mat();
}

std::shared_ptr<const std::vector<SeedView>> SnapshotBuilder::seedViews(const Tracker& tracker) {
  auto views = std::make_shared<std::vector<SeedView>>();
  const auto& keyframes = tracker.map().keyframes;
  for (auto it = depths_.begin(); it != depths_.end();)
    it = keyframes.count(it->first) ? std::next(it) : depths_.erase(it);
  for (const auto& [id, keyframe] : keyframes) {
    if (keyframe.seeds.empty() && keyframe.segment_seeds.empty()) continue;
    const SE3 T_world_kf = keyframe.T_cam_world.inverse();
    const cv::Mat& depth = depthOf(keyframe);
    for (const Seed& seed : keyframe.seeds) views->push_back(seedView(seed, tracker, T_world_kf, depth));
    for (const SegmentSeed& seed : keyframe.segment_seeds) views->push_back(segmentSeedView(seed, keyframe, tracker, depth));
  }
  for (const OrphanSeed& orphan : tracker.map().orphans)
    views->push_back(seedView(orphan.seed, tracker, orphan.T_cam_world.inverse(), cv::Mat()));
  return views;
}

std::shared_ptr<const std::vector<KeyframeView>> SnapshotBuilder::keyframeViews(const Tracker& tracker) {
  auto views = std::make_shared<std::vector<KeyframeView>>();
  for (const RetiredKeyframe& k : tracker.map().retired)
    views->push_back({k.id, k.frame_index, k.T_world_cam, nullptr, false});
  for (const auto& [id, keyframe] : tracker.map().keyframes)
    views->push_back({id, keyframe.frame_index, keyframe.T_cam_world.inverse(), keyframe.pyramid, true});
  std::sort(views->begin(), views->end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  return views;
}

std::shared_ptr<const std::vector<MapPointView>> SnapshotBuilder::pointViews(const Tracker& tracker) {
  auto views = std::make_shared<std::vector<MapPointView>>();
  views->reserve(tracker.map().landmarks.size());
  for (const auto& [id, landmark] : tracker.map().landmarks) {
    MapPointView v;
    v.id = id;
    v.position = landmark.p_world.cast<float>();
    v.type = landmark.type;
    v.sigma = static_cast<float>(landmark.sigma);
    v.observations = static_cast<int>(landmark.observations.size());
    v.reference_keyframe = landmark.observations.empty() ? -1 : landmark.observations.front().keyframe_id;
    views->push_back(v);
  }
  for (const auto& [id, segment] : tracker.map().segments) views->push_back(segmentPointView(segment));
  std::sort(views->begin(), views->end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  return views;
}

std::shared_ptr<Snapshot> SnapshotBuilder::buildEmpty() {
  auto s = std::make_shared<Snapshot>();
  s->sequence_number = ++sequence_number_;
  s->bytes = sizeof(Snapshot);
  return s;
}

std::shared_ptr<const MappingParameters> SnapshotBuilder::mappingOf(const Tracker& tracker) {
  if (!mapping_) mapping_ = std::make_shared<const MappingParameters>(tracker.parameters().mapping);
  return mapping_;
}

std::shared_ptr<Snapshot> SnapshotBuilder::build(Tracker& tracker) {
  auto s = std::make_shared<Snapshot>();
  s->sequence_number = ++sequence_number_;
  s->record = tracker.record();
  s->pyramid = tracker.frame().pyramid;
  s->events = tracker.events();
  s->features.reserve(tracker.frame().features.size() + tracker.failedFeatures().size());
  for (const TrackedFeature& f : tracker.frame().features) s->features.push_back(featureView(f, tracker));
  for (const TrackedFeature& f : tracker.failedFeatures()) s->features.push_back(featureView(f, tracker));
  for (const TrackedSegment& f : tracker.frame().segments) s->features.push_back(segmentFeatureView(f, tracker));
  for (const TrackedSegment& f : tracker.failedSegments()) s->features.push_back(segmentFeatureView(f, tracker));
  if (tracker.record().state == TrackingState::initializing) {
    for (const InitializerTrack& t : tracker.startOutput().tracks) s->features.push_back(trackView(t));
  }
  s->seeds = seedViews(tracker);
  s->seed_updates = std::make_shared<const std::vector<SeedUpdateView>>(tracker.takeSeedUpdates());
  s->mapping = mappingOf(tracker);
  s->bytes = sizeof(Snapshot) + s->features.size() * sizeof(FeatureView) + s->seeds->size() * sizeof(SeedView) +
             s->seed_updates->size() * sizeof(SeedUpdateView);
  // Poses and points move a little in every frame; shown anew when the map gained or lost keyframes.
  const std::size_t count = tracker.map().keyframes.size() + tracker.map().retired.size();
  if (!keyframes_ || tracker.record().is_keyframe || keyframes_->size() != count) {
    keyframes_ = keyframeViews(tracker);
    points_ = pointViews(tracker);
    s->bytes += keyframes_->size() * sizeof(KeyframeView) + points_->size() * sizeof(MapPointView);
  }
  s->keyframes = keyframes_;
  s->points = points_;
  if (s->pyramid) {
    for (const cv::Mat& level : *s->pyramid) s->bytes += level.total();
  }
  return s;
}

}  // namespace svoscope
