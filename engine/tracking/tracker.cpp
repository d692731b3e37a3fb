// SPDX-License-Identifier: MIT
#include "engine/tracking/tracker.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/stopwatch.h"
#include "engine/tracking/tracker_attempt.h"

namespace svoscope {

namespace {

double& stageMs(FrameRecord& record, Stage s) { return record.time_ms[static_cast<int>(s)]; }

std::vector<PoseObservation> observationsOf(const std::vector<TrackedFeature>& features) {
  std::vector<PoseObservation> observations;
  observations.reserve(features.size());
  for (const TrackedFeature& f : features) {
    observations.push_back({f.anchor.px, f.p_world, f.anchor.level, f.anchor.type, f.anchor.gradient_dir,
                            f.origin == FeatureOrigin::unconverged_seed});
  }
  return observations;
}

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

Tracker::Tracker(const Pinhole& camera, const TrackerParameters& parameters) : parameters_(parameters) {
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
  lost_frames_ = 0;
  last_keyframe_frame_ = latest_keyframe_ = -1;
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
    case TrackingState::initializing: initialize(); break;
    case TrackingState::tracking: trackFrame(); break;
    case TrackingState::lost: relocalize(); break;
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
  if (start_output_.initialized) {
    buildMap(start_output_);
    T_last_good_ = frame_.T_cam_world;
    T_velocity_ = startVelocity(start_output_);
    state_ = TrackingState::tracking;
    record_.pose_good = true;
    event(EventKind::initialized, "started: " + start_output_.reason);
    insertKeyframe("second view of the start");
    requestMeasurements();
  }
  stageMs(record_, Stage::initialize) = watch.ms();
}

void Tracker::trackFrame() {
  const auto& p = parameters_;
  const auto patches = alignmentPatches();
  const int top = std::min<int>(p.alignment.max_level, static_cast<int>(frame_.pyramid->size()) - 1);
  Stopwatch watch;
  const double moving = photometricError(*last_.pyramid, *frame_.pyramid, map_.camera, patches, T_velocity_, top);
  const double still = photometricError(*last_.pyramid, *frame_.pyramid, map_.camera, patches, SE3(), top);
  stageMs(record_, Stage::sparse_align) += watch.ms();
  const bool use_velocity = moving <= still;

  Attempt best = alignAndAttempt(use_velocity ? T_velocity_ : SE3(), use_velocity ? "constant velocity" : "standing");
  if (!accept(best, p.quality.min_inliers)) {
    Attempt other = alignAndAttempt(use_velocity ? SE3() : T_velocity_, use_velocity ? "standing" : "constant velocity");
    if (accept(other, p.quality.min_inliers)) {
      best = std::move(other);
    } else {
      // The record holds the numbers of the attempt judged last: so does the reason.
      lose(other.failure);
      return;
    }
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

Tracker::Attempt Tracker::alignAndAttempt(const SE3& T_cur_prev, const char* from) {
  Stopwatch watch;
  const SparseAlignmentResult aligned = alignSparse(*last_.pyramid, *frame_.pyramid, map_.camera, alignmentPatches(),
                                                    T_cur_prev, parameters_.alignment);
  stageMs(record_, Stage::sparse_align) += watch.ms();
  Attempt a = attempt((aligned.ok ? aligned.T_cur_ref : T_cur_prev) * last_.T_cam_world, from);
  a.aligned = aligned;
  return a;
}

Tracker::Attempt Tracker::attempt(const SE3& T_cam_world, const char* from) {
  Attempt a;
  a.from = from;
  Stopwatch watch;
  frame_.T_cam_world = T_cam_world;
  a.reprojected = reprojectMap(map_, frame_, parameters_.reproject, parameters_.mapping);
  stageMs(record_, Stage::reproject) += watch.lapMs();
  const auto observations = observationsOf(a.reprojected.features);
  a.pose = refinePose(map_.camera, observations, T_cam_world, parameters_.pose);
  stageMs(record_, Stage::pose) += watch.lapMs();
  if (parameters_.mapping.segments.enabled) {
    // The points' pose predicts the lines: fewer steps, and no jump to a parallel edge.
    if (a.pose.ok && a.pose.inliers >= parameters_.quality.min_inliers) frame_.T_cam_world = a.pose.T_cam_world;
    a.segments = trackSegments(map_, frame_, a.reprojected.local_keyframes, parameters_.mapping);
    stageMs(record_, Stage::reproject) += watch.lapMs();
    if (!a.segments.segments.empty()) {
      const auto lines = segmentObservations(map_.camera, a.segments.segments, frame_.T_cam_world, parameters_.mapping.segments);
      a.pose = refinePose(map_.camera, observations, frame_.T_cam_world, parameters_.pose, lines, parameters_.mapping.segments);
      for (std::size_t i = 0; i < lines.size(); ++i) a.segments.segments[i].informs = lines[i].informs;
    }
    stageMs(record_, Stage::pose) += watch.lapMs();
  }
  a.T_cam_world = a.pose.T_cam_world;
  return a;
}

/// Judges an attempt; if good, its features become the frame's and its numbers the record's.
bool Tracker::accept(Attempt& a, int required) {
  const int matched = static_cast<int>(a.reprojected.features.size() + a.segments.segments.size());
  const int inliers = a.pose.inliers + a.pose.segment_inliers;
  record_.align_rmse = a.aligned.rmse;
  record_.gain = a.aligned.gain;
  record_.offset = a.aligned.offset;
  Funnel& funnel = record_.funnel;
  funnel.aligned_sparse = a.aligned.patches;
  funnel.candidates = a.reprojected.candidates + a.segments.candidates;
  funnel.projected = a.reprojected.projected + a.segments.projected;
  funnel.tried = a.reprojected.tried + a.segments.tried;
  funnel.matched = matched;
  funnel.inliers = inliers;
  funnel.required = required;
  failed_features_ = a.reprojected.failed;
  failed_segments_ = a.segments.failed;
  local_keyframes_ = a.reprojected.local_keyframes;
  if (matched < required) {
    a.failure = fmt::format("{} features matched of {} tried, {} required", matched, funnel.tried, required);
  } else if (!a.pose.ok || inliers < required) {
    a.failure = fmt::format("{} inliers of {} matched, {} required", inliers, matched, required);
  } else if (inliers < parameters_.quality.min_inlier_fraction * matched) {
    a.failure = fmt::format("{} inliers are under {:.0f} % of {} matched", inliers,
                            100 * parameters_.quality.min_inlier_fraction, matched);
  }
  if (!a.failure.empty()) return false;
  for (std::size_t i = 0; i < a.reprojected.features.size(); ++i) {
    TrackedFeature& f = a.reprojected.features[i];
    f.error_px = a.pose.error_px[i];
    f.status = a.pose.inlier[i] ? FeatureStatus::inlier : FeatureStatus::outlier;
  }
  frame_.features = a.reprojected.features;
  acceptSegments(a);
  occupied_ = a.reprojected.occupied;
  countTries();
  return true;
}

/// Only frames with a pose count: while lost, the map is not to blame for what it does not match.
void Tracker::countTries() {
  const auto count = [](auto& landmark, bool good, int max_failures) {
    ++(good ? landmark.succeeded : landmark.failed);
    return landmark.failed <= max_failures || landmark.failed <= landmark.succeeded / 4;
  };
  const auto countPoint = [&](const TrackedFeature& f) {
    Landmark* landmark = f.origin == FeatureOrigin::landmark ? map_.find(f.id) : nullptr;
    const bool keep = !landmark || count(*landmark, f.status == FeatureStatus::inlier, parameters_.reproject.max_failures);
    if (!keep) map_.removeLandmark(f.id);
  };
  const auto countSegment = [&](const TrackedSegment& s) {
    const auto it = s.origin == FeatureOrigin::landmark ? map_.segments.find(s.id) : map_.segments.end();
    const bool keep = it == map_.segments.end() || count(it->second, s.status == FeatureStatus::inlier,
                                                         parameters_.mapping.segments.max_failures);
    if (!keep) map_.removeSegment(s.id);
  };
  for (const auto* features : {&frame_.features, &failed_features_}) {
    for (const TrackedFeature& f : *features) countPoint(f);
  }
  for (const auto* segments : {&frame_.segments, &failed_segments_}) {
    for (const TrackedSegment& s : *segments) countSegment(s);
  }
}

void Tracker::lose(const std::string& reason) {
  state_ = TrackingState::lost;
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
  const bool fresh = static_cast<int>(map_.keyframes.size()) <= parameters_.quality.fresh_map_keyframes;
  if (fresh && lost_frames_ > parameters_.quality.reset_lost_frames) {
    event(EventKind::reset, "the young map was given up, starting again");
    const Frame current = frame_;
    const std::int64_t next_id = map_.next_id;
    const int next_keyframe_id = map_.next_keyframe_id;
    reset();
    frame_ = current;
    // Mapping answers on their way, and what is kept by keyframe, still speak of the old map.
    map_.next_id = next_id;
    map_.next_keyframe_id = next_keyframe_id;
    initialize();
    return;
  }
  auto candidates = relocalizationCandidates(map_, *frame_.pyramid, parameters_.alignment, parameters_.relocalize);
  std::string failure = "no keyframe looks like this frame";
  for (const RelocalizationCandidate& c : candidates) {
    Attempt a = attempt(c.T_cam_world, "relocalization");
    // Once more from the refined pose: the first pass finds only what lay near its prediction.
    if (a.pose.inliers + a.pose.segment_inliers >= parameters_.quality.min_inliers) a = attempt(a.T_cam_world, "relocalization");
    if (accept(a, parameters_.quality.relocalized_inliers)) {
      frame_.T_cam_world = T_last_good_ = a.T_cam_world;
      T_velocity_ = SE3();
      state_ = TrackingState::tracking;
      record_.pose_good = record_.relocalized = true;
      record_.reason = fmt::format("relocalized on keyframe {}", c.keyframe_id);
      event(EventKind::relocalized, fmt::format("{} after {} frames", record_.reason, lost_frames_));
      commitSeedMatches(a.reprojected.seed_matches);
      commitSegments();
      requestMeasurements();
      stageMs(record_, Stage::relocalize) = watch.ms();
      return;
    }
    failure = fmt::format("keyframe {}: {}", c.keyframe_id, a.failure);
  }
  frame_.T_cam_world = T_last_good_;
  record_.reason = "lost, " + failure;
  stageMs(record_, Stage::relocalize) = watch.ms();
}

void Tracker::event(EventKind kind, std::string text) {
  events_.push_back({record_.index, kind, std::move(text)});
}

void Tracker::finishRecord() {
  record_.state = state_;
  record_.T_world_cam = frame_.T_cam_world.inverse();
  Funnel& funnel = record_.funnel;
  std::vector<double> errors;
  for (const TrackedFeature& f : frame_.features) {
    if (f.status != FeatureStatus::inlier) continue;
    errors.push_back(f.error_px);
    ++(f.origin == FeatureOrigin::landmark ? funnel.inlier_landmarks : funnel.inlier_seeds);
    funnel.inlier_edgelets += f.anchor.type == FeatureType::edgelet;
  }
  for (const TrackedSegment& s : frame_.segments) {
    if (s.status != FeatureStatus::inlier || !s.informs) continue;
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
