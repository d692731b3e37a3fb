// SPDX-License-Identifier: MIT
#include "engine/tracking/tracker.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/stopwatch.h"
#include "engine/tracking/tracker_attempt.h"

namespace svoscope {

namespace {

/// Motion of the last frame before the start's current one, if the start knows it.
SE3 startVelocity(const InitializerOutput& start) {
  const auto& poses = start.poses;
  if (poses.size() < 2) return SE3();
  const InitializerPose& last = poses[poses.size() - 2];
  const InitializerPose& current = poses.back();
  if (current.frame_index != last.frame_index + 1) return SE3();
  return current.T_frame_ref * last.T_frame_ref.inverse();
}

}  // namespace

Tracker::Tracker(const Pinhole& camera, const TrackerParameters& parameters)
    : parameters_(parameters) {
  map_.camera = camera;
  reset();
}

void Tracker::reset() {
  const Pinhole camera = map_.camera;
  map_ = Map{};
  map_.camera = camera;
  initializer_ = std::make_unique<Initializer>(camera, parameters_.start);
  start_output_ = {};
  state_ = TrackingState::initializing;
  frame_ = last_ = Frame{};
  T_velocity_ = T_last_good_ = SE3();
  job_.reset();
  local_keyframes_.clear();
  seed_updates_.clear();
  places_.clear();
  restart_.reset();
  lost_frames_ = map_id_ = 0;
  last_keyframe_frame_ = latest_keyframe_ = awaited_adjustment_ = -1;
  adjustment_wanted_ = false;
  usual_noise_px_ = 0;
}

const FrameRecord& Tracker::process(int index, double timestamp, const cv::Mat& gray) {
  Stopwatch total;
  record_ = FrameRecord{};
  record_.index = index;
  record_.timestamp = timestamp;
  events_.clear();
  failed_features_.clear();
  failed_segments_.clear();
  measured_seeds_.clear();
  dropEndedSeeds();

  last_ = std::move(frame_);
  frame_ = Frame{};
  frame_.index = index;
  frame_.timestamp = timestamp;
  Stopwatch watch;
  frame_.pyramid = buildPyramid(gray, pyramidLevels(gray.cols));
  stageMs(record_, Stage::pyramid) = watch.ms();

  switch (state_) {
    case TrackingState::initializing:
      initialize();
      break;
    case TrackingState::tracking:
      trackFrame();
      break;
    case TrackingState::lost:
      relocalize();
      break;
  }
  finishRecord();
  stageMs(record_, Stage::tracking) = total.ms();
  return record_;
}

void Tracker::initialize() {
  Stopwatch watch;
  start_output_ = initializer_->process({frame_.index, frame_.timestamp, frame_.pyramid});
  record_.disparity_tracks = start_output_.tracks_alive;
  record_.disparity_px = start_output_.disparity_px;
  record_.reason = start_output_.reason;
  if (start_output_.initialized) beginMap(start_output_);
  stageMs(record_, Stage::initialize) = watch.ms();
}

void Tracker::beginMap(InitializerOutput start) {
  buildMap(start);
  T_last_good_ = frame_.T_cam_world;
  T_velocity_ = startVelocity(start);
  state_ = TrackingState::tracking;
  record_.pose_good = true;
  record_.reason = start.reason;
  event(EventKind::initialized, "started: " + start.reason);
  insertKeyframe("second view of the start");
  requestMeasurements();
  start_output_ = std::move(start);
}

void Tracker::trackFrame() {
  Stopwatch watch;
  const auto patches = alignmentPatches();
  const auto list = predictions(patches);
  stageMs(record_, Stage::sparse_align) += watch.ms();
  Attempt best;
  const bool tracked = std::any_of(
      list.begin(), list.end(), [&](const Prediction& p) { return trackFrom(p, patches, best); });
  if (!tracked) {
    // The record holds the numbers of the attempt judged last: so does the reason.
    lose(best.failure);
    return;
  }
  frame_.T_cam_world = best.T_cam_world;
  T_velocity_ = frame_.T_cam_world * last_.T_cam_world.inverse();
  T_last_good_ = frame_.T_cam_world;
  record_.pose_good = true;
  record_.reason = "tracking";

  watch.lapMs();
  commitSeedMatches(best.reprojected.seed_matches);
  commitSegments();
  refineStructure();
  refineSegments();
  stageMs(record_, Stage::structure) = watch.lapMs();
  const KeyframeDecision decision = considerKeyframe();
  record_.keyframe_reason = decision.reason;
  if (decision.take) insertKeyframe(decision.reason);
  requestMeasurements();
  stageMs(record_, Stage::keyframe) = watch.lapMs();
}

void Tracker::lose(const std::string& reason) {
  state_ = TrackingState::lost;
  restart_.reset();
  lost_frames_ = 0;
  frame_.T_cam_world = T_last_good_;
  T_velocity_ = SE3();
  record_.reason = reason;
  event(EventKind::lost, "lost: " + reason);
}

void Tracker::relocalize() {
  Stopwatch watch;
  ++lost_frames_;
  frame_.T_cam_world = T_last_good_;
  // Alignment first: it is exact where it converges. Descriptors reach further.
  std::string failure = "no keyframe looks like this frame";
  const bool found =
      tryRelocalization(relocalizationCandidates(map_, *frame_.pyramid, parameters_.alignment,
                                                 parameters_.relocalize),
                        "alignment", failure) ||
      tryRelocalization(matchPlaces(map_, *frame_.pyramid, places_, parameters_.relocalize),
                        "descriptors", failure);
  stageMs(record_, Stage::relocalize) = watch.lapMs();
  if (found) return restart_.reset();
  frame_.T_cam_world = T_last_good_;
  record_.reason = "lost, " + failure;
  const QualityParameters& q = parameters_.quality;
  const bool fresh = static_cast<int>(map_.keyframes.size()) <= q.fresh_map_keyframes;
  if (lost_frames_ > (fresh ? q.fresh_lost_frames : q.lost_frames)) startBeside();
  stageMs(record_, Stage::initialize) = watch.lapMs();
}

/// The camera may be where the map has never been. The map is given up only once another has begun:
/// until then the camera may come back.
void Tracker::startBeside() {
  if (!restart_) restart_ = std::make_unique<Initializer>(map_.camera, parameters_.start);
  InitializerOutput start = restart_->process({frame_.index, frame_.timestamp, frame_.pyramid});
  if (!start.initialized) return;
  event(EventKind::reset,
        fmt::format("map {} was given up after {} frames without it: another start was found",
                    map_id_, lost_frames_));
  const Frame current = frame_;
  const int map_id = map_id_ + 1, next_keyframe_id = map_.next_keyframe_id;
  const std::int64_t next_id = map_.next_id;
  reset();
  frame_ = current;
  map_id_ = map_id;
  // Mapping answers on their way, and what is kept by keyframe, still speak of the old map.
  map_.next_id = next_id;
  map_.next_keyframe_id = next_keyframe_id;
  beginMap(std::move(start));
}

/// Takes the first candidate that the map confirms.
bool Tracker::tryRelocalization(const std::vector<RelocalizationCandidate>& candidates,
                                const char* by, std::string& failure) {
  const QualityParameters& q = parameters_.quality;
  for (const RelocalizationCandidate& c : candidates) {
    const Scope sure = {0, false};
    Attempt a = attempt(c.T_cam_world, "relocalization", sure);
    // Once more from the refined pose: the first pass finds only what lay near its prediction.
    if (a.pose.inliers + a.pose.segment_inliers >= q.min_inliers)
      a = attempt(a.T_cam_world, "relocalization", sure);
    if (!acceptRelocalization(a)) {
      failure = fmt::format("keyframe {} by {}: {}", c.keyframe_id, by, a.failure);
      continue;
    }
    frame_.T_cam_world = T_last_good_ = a.T_cam_world;
    T_velocity_ = SE3();
    state_ = TrackingState::tracking;
    record_.pose_good = record_.relocalized = true;
    record_.reason = fmt::format("relocalized on keyframe {} by {}", c.keyframe_id, by);
    event(EventKind::relocalized, fmt::format("{} after {} frames", record_.reason, lost_frames_));
    commitSeedMatches(a.reprojected.seed_matches);
    commitSegments();
    requestMeasurements();
    return true;
  }
  return false;
}

void Tracker::event(EventKind kind, std::string text) {
  events_.push_back({record_.index, kind, std::move(text)});
}

void Tracker::finishRecord() {
  record_.state = state_;
  record_.T_world_cam = frame_.T_cam_world.inverse();
  record_.map_id = map_id_;
  Funnel& funnel = record_.funnel;
  std::vector<double> errors;
  for (const TrackedFeature& f : frame_.features) {
    if (f.status != FeatureStatus::inlier) continue;
    errors.push_back(f.error_px);
    ++(f.origin == FeatureOrigin::landmark ? funnel.inlier_landmarks : funnel.inlier_seeds);
    funnel.inlier_edgelets += f.anchor.type == FeatureType::edgelet;
  }
  for (const TrackedSegment& s : frame_.segments) {
    if (s.status != FeatureStatus::inlier) continue;
    if (!s.informs) {
      ++funnel.followed_segments;
      continue;
    }
    ++funnel.inlier_segments;
    ++(s.origin == FeatureOrigin::landmark ? funnel.inlier_landmarks : funnel.inlier_seeds);
  }
  if (!errors.empty()) {
    auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
    std::nth_element(errors.begin(), middle, errors.end());
    record_.reprojection_px = *middle;
  }
  double near = 0;
  depthStatistics(frame_, record_.median_depth, near);
  record_.landmarks = static_cast<int>(map_.landmarks.size() + map_.segments.size());
  record_.seeds = map_.seedCount();
  record_.keyframes = static_cast<int>(map_.keyframes.size());
}

}  // namespace svoscope
