// SPDX-License-Identifier: MIT
#include "engine/runner/engine.h"

#include <algorithm>

#include "engine/base/stopwatch.h"

namespace svoscope {

Engine::Engine(std::unique_ptr<Sequence> sequence, const Parameters& parameters, int start,
               int max_frames, std::string method)
    : sequence_(std::move(sequence)),
      rectifier_(sequence_->camera()),
      parameters_(parameters),
      tracker_(rectifier_.pinhole(), parameters.tracker),
      builder_([this](int frame_index) { return rectifiedDepth(frame_index); }) {
  start_ = std::clamp(start, 0, sequence_->size());
  end_ = max_frames < 0 ? sequence_->size() : std::min(sequence_->size(), start_ + max_frames);
  next_ = start_;
  info_.sequence = sequence_->name();
  info_.method = std::move(method);
  info_.frames = end_;
  info_.rate_hz = sequence_->camera().rate_hz;
  info_.camera = rectifier_.pinhole();
  info_.original_camera = sequence_->camera();
  info_.ground_truth = sequence_->groundTruth();
  info_.times = timeSourceName(sequence_->timeSource());
  info_.notes = sequence_->notes();
  if (sequence_->timeSource() == TimeSource::assumed && !info_.ground_truth.empty()) {
    // Matched by assumed times, the errors would look right and be wrong.
    info_.ground_truth.clear();
    info_.truth_note = "the times of the images are assumed: give their rate with --rate HZ";
  }
}

cv::Mat Engine::rectifiedDepth(int frame_index) {
  const Result<cv::Mat> depth = sequence_->readDepth(frame_index);
  return depth.ok() && !depth.value().empty() ? rectifier_.rectifyDepth(depth.value()) : cv::Mat();
}

void Engine::step() {
  if (finished()) return;
  const int index = next_++;
  const bool first = index == start_;
  Stopwatch watch;
  Result<SequenceImage> image = sequence_->read(index);
  const double read_ms = watch.lapMs();
  image_good_ = image.ok();
  if (!image_good_) {
    record_ = FrameRecord{};
    record_.index = index;
    record_.timestamp = sequence_->timestamp(index);
    record_.state = tracker_.record().state;
    record_.reason = "image not readable";
    events_ = {{index, EventKind::warning, image.error().message()}};
    if (first) addNotes();
    return;
  }
  const cv::Mat gray = rectifier_.rectify(image.value().gray);
  const double rectify_ms = watch.ms();
  tracker_.process(index, image.value().timestamp, gray);
  record_ = tracker_.record();
  record_.time_ms[static_cast<int>(Stage::read)] = read_ms;
  record_.time_ms[static_cast<int>(Stage::rectify)] = rectify_ms;
  events_ = tracker_.events();
  if (first) addNotes();
}

/// The log begins with what was assumed.
void Engine::addNotes() {
  std::vector<Event> notes;
  for (const std::string& text : info_.notes) notes.push_back({start_, EventKind::info, text});
  events_.insert(events_.begin(), notes.begin(), notes.end());
}

void Engine::refreshRecord() {
  if (!image_good_) return;
  const double read_ms = record_.ms(Stage::read), rectify_ms = record_.ms(Stage::rectify);
  record_ = tracker_.record();
  record_.time_ms[static_cast<int>(Stage::read)] = read_ms;
  record_.time_ms[static_cast<int>(Stage::rectify)] = rectify_ms;
}

SnapshotPtr Engine::snapshot() {
  Stopwatch watch;
  if (finished()) builder_.showMapAnew();  // the last one is what remains of the run
  std::shared_ptr<Snapshot> s = image_good_ ? builder_.build(tracker_) : builder_.buildEmpty();
  record_.time_ms[static_cast<int>(Stage::snapshot)] = watch.ms();
  s->record = record_;
  s->events = events_;
  return s;
}

Status Engine::setParameter(const std::string& key, const std::string& value) {
  Status status = svoscope::setParameter(parameters_, key, value);
  if (status.ok()) {
    tracker_.setParameters(parameters_.tracker);
    builder_.parametersChanged();
  }
  return status;
}

void Engine::reset() {
  tracker_.reset();
  builder_.reset();
  record_ = FrameRecord{};
  events_.clear();
  image_good_ = false;
  next_ = start_;
}

}  // namespace svoscope
