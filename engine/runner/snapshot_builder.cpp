// SPDX-License-Identifier: MIT
#include "engine/runner/snapshot_builder.h"

#include <algorithm>
#include <cmath>

#include "engine/runner/segment_views.h"
#include "engine/snapshot/seed_placement.h"

namespace svoscope {

namespace {

/// Angle of an edgelet's gradient; corners have none.
float directionOf(const FeatureAnchor& anchor) {
  if (anchor.type != FeatureType::edgelet) return 0;
  return static_cast<float>(std::atan2(anchor.gradient_dir.y(), anchor.gradient_dir.x()));
}

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
  v.direction = directionOf(f.anchor);
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
SeedView seedState(const Seed& seed, FilterRule rule_in_use) {
  SeedView v;
  v.id = seed.id;
  v.keyframe_id = seed.keyframe_id;
  v.type = seed.anchor.type;
  v.status = seed.status;
  v.ending = seed.ending;
  v.outcome = seed.outcome;
  v.level = static_cast<std::uint8_t>(seed.anchor.level);
  v.px_ref = seed.anchor.px.cast<float>();
  v.direction = directionOf(seed.anchor);
  v.mu = static_cast<float>(seed.belief.mu);
  v.sigma = static_cast<float>(std::sqrt(seed.belief.sigma2));
  v.a = static_cast<float>(seed.belief.a);
  v.b = static_cast<float>(seed.belief.b);
  for (const FilterRule rule : kRules) v.belief[rule] = beliefView(seed, rule, rule_in_use);
  v.range = static_cast<float>(seed.range);
  v.updates = seed.updates;
  v.failures = seed.failures;
  v.last_x = static_cast<float>(seed.last_x);
  v.last_tau = static_cast<float>(seed.last_tau);
  return v;
}

SeedView seedView(const Seed& seed, const Tracker& tracker, const SeedPlacement& placement,
                  const cv::Mat& depth) {
  SeedView v = seedState(seed, tracker.parameters().mapping.filter.rule);
  placeSeed(v, placement);
  const int x = static_cast<int>(std::lround(seed.anchor.px.x())),
            y = static_cast<int>(std::lround(seed.anchor.px.y()));
  if (!depth.empty() && x >= 0 && y >= 0 && x < depth.cols && y < depth.rows) {
    // Depth images hold z; seeds measure along the ray.
    const float true_z = depth.at<float>(y, x);
    if (true_z > 0) v.true_inv_distance = static_cast<float>(seed.anchor.f.z()) / true_z;
  }
  return v;
}

/// Poses of keyframes that the view does not know, or knows otherwise.
bool moved(const std::vector<KeyframeView>& views, const Map& map) {
  if (views.size() != map.keyframes.size() + map.retired.size()) return true;
  for (const KeyframeView& view : views) {
    if (!view.in_map) continue;
    const auto it = map.keyframes.find(view.id);
    if (it == map.keyframes.end()) return true;
    const SE3 now = it->second.T_cam_world.inverse();
    if (now.translation() != view.T_world_cam.translation() ||
        now.quaternion().coeffs() != view.T_world_cam.quaternion().coeffs())
      return true;
  }
  return false;
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
  std::size_t count = tracker.map().orphans.size() + tracker.map().segment_orphans.size();
  for (const auto& [id, keyframe] : keyframes)
    count += keyframe.seeds.size() + keyframe.segment_seeds.size();
  views->reserve(count);
  const SE3 T_cam_world = tracker.record().T_world_cam.inverse();
  const double sigmas = tracker.parameters().mapping.search.search_sigmas;
  const auto placed = [&](const SE3& T_world_kf) {
    return SeedPlacement{T_world_kf, T_cam_world, tracker.map().camera, sigmas, placed_};
  };
  for (auto it = depths_.begin(); it != depths_.end();)
    it = keyframes.count(it->first) ? std::next(it) : depths_.erase(it);
  for (const auto& [id, keyframe] : keyframes) {
    if (keyframe.seeds.empty() && keyframe.segment_seeds.empty()) continue;
    const SeedPlacement placement = placed(keyframe.T_cam_world.inverse());
    const cv::Mat& depth = depthOf(keyframe);
    for (const Seed& seed : keyframe.seeds)
      views->push_back(seedView(seed, tracker, placement, depth));
    for (const SegmentSeed& seed : keyframe.segment_seeds)
      views->push_back(segmentSeedView(seed, tracker, placement, depth));
  }
  for (const OrphanSeed& orphan : tracker.map().orphans)
    views->push_back(
        seedView(orphan.seed, tracker, placed(orphan.T_cam_world.inverse()), cv::Mat()));
  for (const OrphanSegmentSeed& orphan : tracker.map().segment_orphans)
    views->push_back(
        segmentSeedView(orphan.seed, tracker, placed(orphan.T_cam_world.inverse()), cv::Mat()));
  return views;
}

std::shared_ptr<const std::vector<KeyframeView>> SnapshotBuilder::keyframeViews(
    const Tracker& tracker) {
  auto views = std::make_shared<std::vector<KeyframeView>>();
  for (const RetiredKeyframe& k : tracker.map().retired)
    views->push_back({k.id, k.frame_index, k.T_world_cam, nullptr, false});
  for (const auto& [id, keyframe] : tracker.map().keyframes)
    views->push_back(
        {id, keyframe.frame_index, keyframe.T_cam_world.inverse(), keyframe.pyramid, true});
  std::sort(views->begin(), views->end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  return views;
}

std::shared_ptr<const std::vector<MapPointView>> SnapshotBuilder::pointViews(
    const Tracker& tracker) {
  auto views = std::make_shared<std::vector<MapPointView>>();
  views->reserve(tracker.map().landmarks.size());
  for (const auto& [id, landmark] : tracker.map().landmarks) {
    MapPointView v;
    v.id = id;
    v.position = landmark.p_world.cast<float>();
    v.type = landmark.type;
    v.sigma = static_cast<float>(landmark.sigma);
    v.observations = static_cast<int>(landmark.observations.size());
    v.reference_keyframe =
        landmark.observations.empty() ? -1 : landmark.observations.front().keyframe_id;
    views->push_back(v);
  }
  for (const auto& [id, segment] : tracker.map().segments)
    views->push_back(segmentPointView(segment));
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
  for (const TrackedFeature& f : tracker.frame().features)
    s->features.push_back(featureView(f, tracker));
  for (const TrackedFeature& f : tracker.failedFeatures())
    s->features.push_back(featureView(f, tracker));
  for (const TrackedSegment& f : tracker.frame().segments)
    s->features.push_back(segmentFeatureView(f, tracker));
  for (const TrackedSegment& f : tracker.failedSegments())
    s->features.push_back(segmentFeatureView(f, tracker));
  if (tracker.record().state == TrackingState::initializing) {
    for (const InitializerTrack& t : tracker.startOutput().tracks)
      s->features.push_back(trackView(t));
  }
  s->seeds = seedViews(tracker);
  s->seed_updates = std::make_shared<const std::vector<SeedUpdateView>>(tracker.takeSeedUpdates());
  s->mapping = mappingOf(tracker);
  s->bytes = sizeof(Snapshot) + s->features.size() * sizeof(FeatureView) +
             s->seeds->size() * sizeof(SeedView) + s->seed_updates->size() * sizeof(SeedUpdateView);
  // Points move a little in every frame; they are republished with the keyframes, when one was
  // added, removed or adjusted.
  if (!keyframes_ || tracker.record().is_keyframe || moved(*keyframes_, tracker.map())) {
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
