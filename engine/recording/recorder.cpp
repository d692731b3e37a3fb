// SPDX-License-Identifier: MIT
#include "engine/recording/recorder.h"

#include <chrono>

namespace svoscope {

namespace {

constexpr std::size_t kMostWaiting = 24;  // snapshots with their images, some 20 MB at 640 x 480
constexpr int kFramesPerCommit = 8;
constexpr auto kLongestUncommitted = std::chrono::milliseconds(500);

}  // namespace

Status Recorder::start(const std::filesystem::path& file, const RecordingOptions& options) {
  auto writer = RecordingWriter::create(file, options);
  if (!writer.ok()) return writer.error();
  writer_ = std::move(writer).value();
  thread_ = std::thread([this] { loop(); });
  return Done{};
}

Recorder::~Recorder() { (void)close(); }

void Recorder::push(Item item) {
  if (failed_) return;
  queue_.waitBelow(kMostWaiting);
  queue_.push(std::move(item));
}

void Recorder::begin(const RunInfo& info) { push(info); }
void Recorder::parameters(const std::vector<ParameterView>& parameters, int from) {
  push(ParameterSet{parameters, from});
}
void Recorder::frame(const SnapshotPtr& snapshot) { push(snapshot); }
void Recorder::note(const Event& event) { push(event); }
void Recorder::reset() { push(Reset{}); }

Status Recorder::write(const Item& item) {
  if (const auto* snapshot = std::get_if<SnapshotPtr>(&item)) return writer_->frame(**snapshot);
  if (const auto* info = std::get_if<RunInfo>(&item)) return writer_->run(*info);
  if (const auto* event = std::get_if<Event>(&item)) return writer_->event(*event);
  if (const auto* set = std::get_if<ParameterSet>(&item))
    return writer_->parameters(set->values, set->from);
  return writer_->reset();
}

void Recorder::check(const Status& status) {
  if (status.ok() || failed_) return;
  failed_ = true;
  const std::lock_guard<std::mutex> lock(mutex_);
  outcome_ = status;
}

/// Commits every few frames, and what is left when nothing came for a while.
void Recorder::loop() {
  int uncommitted = 0;
  while (!queue_.drained()) {
    const auto item = queue_.popWithin(kLongestUncommitted);
    if (failed_) continue;  // keep the queue empty, so that nobody waits
    if (item) {
      check(write(*item));
      ++uncommitted;
    }
    if (uncommitted >= kFramesPerCommit || (!item && uncommitted > 0)) {
      check(writer_->commit());
      uncommitted = 0;
    }
  }
}

Status Recorder::close() {
  queue_.close();
  if (thread_.joinable()) thread_.join();
  if (writer_ && !failed_) check(writer_->close());
  writer_.reset();
  const std::lock_guard<std::mutex> lock(mutex_);
  return outcome_;
}

}  // namespace svoscope
