// SPDX-License-Identifier: MIT
#include "engine/tracking/tracker.h"

#include <fmt/format.h>

#include "engine/base/stopwatch.h"
#include "engine/tracking/frame_summary.h"

namespace svoscope {

namespace {

double& stageMs(FrameRecord& record, Stage s) {
  return record.time_ms[static_cast<std::size_t>(s)];
}

Frame makeFrame(int index, double timestamp, const cv::Mat& gray) {
  Frame frame;
  frame.index = index;
  frame.timestamp = timestamp;
  frame.pyramid = buildPyramid(gray, pyramidLevels(gray.cols));
  return frame;
}

void addTally(const SeedTally& tally, FrameRecord& record) {
  record.seed_updates += tally.updates;
  record.segment_updates += tally.segment_updates;
  record.seeds_converged += tally.converged;
  record.seeds_rejected += tally.rejected;
}

}  // namespace

Tracker::Tracker(const Pinhole& camera, const TrackerParameters& parameters)
    : parameters_(parameters), keeper_(camera), start_(camera, parameters.start) {}

void Tracker::reset() {
  keeper_.reset(false);
  start_ = Start(map().camera, parameters_.start);
  motion_ = Motion();
  recovery_ = Recovery();
  state_ = TrackingState::initializing;
  map_id_ = 0;
  frame_ = last_ = Frame{};
}

const FrameRecord& Tracker::process(int index, double timestamp, const cv::Mat& gray) {
  Stopwatch total;
  record_ = FrameRecord{};
  record_.index = index;
  record_.timestamp = timestamp;
  events_.clear();
  registration_ = {};
  keeper_.beginFrame(frame_.index);
  last_ = std::move(frame_);
  Stopwatch watch;
  frame_ = makeFrame(index, timestamp, gray);
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
  record_.state = state_;
  record_.map_id = map_id_;
  summarizeFrame(frame_, map(), record_);
  stageMs(record_, Stage::tracking) = total.ms();
  return record_;
}

void Tracker::initialize() {
  Stopwatch watch;
  const InitializerOutput& start = start_.process(frame_);
  record_.disparity_tracks = start.tracks_alive;
  record_.disparity_px = start.disparity_px;
  record_.reason = start.reason;
  if (start.initialized) beginMap(start);
  stageMs(record_, Stage::initialize) = watch.ms();
}

void Tracker::trackFrame() {
  Stopwatch watch;
  const auto predictions = motion_.predict(frame_, last_, map().camera, parameters_);
  stageMs(record_, Stage::sparse_align) += watch.ms();
  for (const Prediction& p : predictions) {
    note(registerFrame(frame_, last_, map(), p, parameters_));
    if (registration_.good()) break;
  }
  if (!registration_.good()) return lose();

  watch.lapMs();
  commit();
  motion_.moved(frame_, last_);
  record_.reason = "tracking";
  keeper_.refine(parameters_, frame_);
  stageMs(record_, Stage::structure) = watch.lapMs();
  const KeyframeDecision decision =
      keeper_.considerKeyframe(frame_, record_.funnel.required, parameters_.keyframe);
  record_.keyframe_reason = decision.reason;
  if (decision.take) makeKeyframe(decision.reason);
  keeper_.requestMapping(frame_, last_, parameters_.mapping);
  stageMs(record_, Stage::keyframe) = watch.lapMs();
}

void Tracker::lose() {
  state_ = TrackingState::lost;
  start_.stopBeside();
  recovery_.begin();
  motion_.stop();
  frame_.T_cam_world = motion_.lastGoodPose();
  // The record holds the numbers of the attempt judged last: so does the reason.
  record_.reason = registration_.failure;
  events_.push_back({frame_.index, EventKind::lost, "lost: " + record_.reason});
}

void Tracker::relocalize() {
  Stopwatch watch;
  frame_.T_cam_world = motion_.lastGoodPose();
  Recovery::Result recovery = recovery_.find(frame_, map(), motion_.usualNoisePx(), parameters_);
  note(std::move(recovery.registration));
  if (recovery.found) {
    commit();
    motion_.foundAt(frame_.T_cam_world);
    state_ = TrackingState::tracking;
    record_.relocalized = true;
    record_.reason = "relocalized on " + recovery.text;
    events_.push_back({frame_.index, EventKind::relocalized,
                       fmt::format("{} after {} frames", record_.reason, recovery_.lostFrames())});
    keeper_.requestMapping(frame_, last_, parameters_.mapping);
    start_.stopBeside();
  } else {
    record_.reason = "lost, " + recovery.text;
  }
  stageMs(record_, Stage::relocalize) = watch.lapMs();
  if (!recovery.found && recovery_.impatient(map(), parameters_.quality)) startBeside();
  if (!recovery.found) stageMs(record_, Stage::initialize) = watch.lapMs();
}

/// The camera may be where the map has never been. The map is given up only once another has begun:
/// until then the camera may come back.
void Tracker::startBeside() {
  const auto start = start_.processBeside(frame_, parameters_.start);
  if (!start) return;
  events_.push_back(
      {frame_.index, EventKind::reset,
       fmt::format("map {} was given up after {} frames without it: another start was found",
                   map_id_, recovery_.lostFrames())});
  ++map_id_;
  keeper_.reset(true);
  start_ = Start(map().camera, parameters_.start);
  motion_ = Motion();
  recovery_ = Recovery();
  beginMap(*start);
  start_.keep(*start);
}

void Tracker::beginMap(const InitializerOutput& start) {
  keeper_.beginMap(start, parameters_, frame_);
  motion_.begin(frame_.T_cam_world, startVelocity(start));
  state_ = TrackingState::tracking;
  record_.pose_good = true;
  record_.reason = start.reason;
  events_.push_back({frame_.index, EventKind::initialized, "started: " + start.reason});
  makeKeyframe("second view of the start");
  last_ = Frame{};  // the frames before the start have no pose
  keeper_.requestMapping(frame_, last_, parameters_.mapping);
}

/// The numbers of an attempt become those of the record, be it refused or not.
void Tracker::note(Registration registration) {
  addTimes(registration.time_ms, record_.time_ms);
  if (!registration.judged) return;
  registration_ = std::move(registration);
  record_.align_rmse = registration_.aligned.rmse;
  record_.gain = registration_.aligned.gain;
  record_.offset = registration_.aligned.offset;
  record_.funnel = registration_.funnel;
  keeper_.setLocalKeyframes(registration_.local_keyframes);
}

/// An accepted registration becomes the frame's, and enters the map.
void Tracker::commit() {
  frame_.T_cam_world = registration_.T_cam_world;
  frame_.noise_px = registration_.noise_px;
  frame_.features = registration_.features;
  frame_.segments = registration_.segments;
  record_.pose_good = true;
  motion_.noteNoise(frame_.noise_px);
  keeper_.noteRegistration(registration_, parameters_, frame_);
  addTally(keeper_.measure(registration_.seed_matches, parameters_.mapping, frame_), record_);
}

void Tracker::makeKeyframe(const std::string& reason) {
  record_.is_keyframe = true;
  record_.keyframe_id = keeper_.insertKeyframe(parameters_, frame_);
  events_.push_back({frame_.index, EventKind::keyframe,
                     fmt::format("keyframe {}: {}", record_.keyframe_id, reason)});
}

void Tracker::applyMapping(MappingResult result) {
  stageMs(record_, Stage::mapping) += result.time_ms;
  const MapKeeper::Answer answer = keeper_.apply(std::move(result), parameters_, frame_);
  addTally(answer.tally, record_);
  if (answer.change) {
    motion_.follow(*answer.change);
    record_.T_world_cam = frame_.T_cam_world.inverse();
  }
  record_.seeds = map().seedCount();
}

}  // namespace svoscope
