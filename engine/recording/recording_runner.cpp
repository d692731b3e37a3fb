// SPDX-License-Identifier: MIT
#include "engine/recording/recording_runner.h"

#include <algorithm>

namespace svoscope {

namespace {

constexpr std::size_t kValuesBudget = 256u << 20, kImagesBudget = 64u << 20;  // bytes

}  // namespace

RecordingRunner::RecordingRunner(std::unique_ptr<RecordingFile> file)
    : file_(std::move(file)), values_(kValuesBudget), wholes_(kImagesBudget) {}

int RecordingRunner::rowOf(int frame_index) const {
  const auto& frames = file_->frames();
  const auto it =
      std::lower_bound(frames.begin(), frames.end(), frame_index,
                       [](const FrameRow& row, int index) { return row.record.index < index; });
  return it != frames.end() && it->record.index == frame_index
             ? static_cast<int>(it - frames.begin())
             : -1;
}

bool RecordingRunner::startsAt(int row) const {
  const int frame = frameAt(row);
  return std::any_of(file_->events().begin(), file_->events().end(),
                     [&](const RecordingFile::EventRow& e) {
                       return e.shown_in == frame && e.event.kind == EventKind::initialized;
                     });
}

void RecordingRunner::goTo(int row) {
  row_ = std::clamp(row, 0, lastRow());
  furthest_ = std::max(furthest_, row_);
  // Notes stand behind the events of the frame after which they came.
  const auto& all = file_->events();
  const int frame = frameAt(furthest_);
  while (recorded_events_ < all.size() && all[recorded_events_].shown_in <= frame)
    events_.push_back(all[recorded_events_++].event);
  if (furthest_ < lastRow() || file_->run().complete || told_incomplete_) return;
  told_incomplete_ = true;
  events_.push_back({frame, EventKind::warning,
                     "the recording was not closed: its run was killed, or still goes on"});
}

int RecordingRunner::nextRow(const Command& command) const {
  const auto& frames = file_->frames();
  if (command.kind == Command::Kind::step) return row_ + 1;
  if (command.kind == Command::Kind::run_to_frame) {
    const auto it =
        std::lower_bound(frames.begin(), frames.end(), command.frame,
                         [](const FrameRow& row, int index) { return row.record.index < index; });
    return static_cast<int>(it - frames.begin());
  }
  for (int row = row_ + 1; row <= lastRow(); ++row) {
    const FrameRecord& record = frames[static_cast<std::size_t>(row)].record;
    if (command.kind == Command::Kind::run_to_keyframe && record.is_keyframe) return row;
    if (command.kind == Command::Kind::run_to_loss && record.state == TrackingState::lost)
      return row;
    if (command.kind == Command::Kind::run_to_start && startsAt(row)) return row;
  }
  return lastRow();
}

void RecordingRunner::send(const Command& command) {
  const std::lock_guard<std::mutex> lock(mutex_);
  switch (command.kind) {
    case Command::Kind::step:
    case Command::Kind::run_to_frame:
    case Command::Kind::run_to_keyframe:
    case Command::Kind::run_to_loss:
    case Command::Kind::run_to_start:
      playback_.finish();
      return goTo(nextRow(command));
    case Command::Kind::set_parameter:
      events_.push_back({row_ < 0 ? -1 : frameAt(row_), EventKind::warning,
                         command.key + " was not set: a recording shows what was computed"});
      return;
    case Command::Kind::reset:
      row_ = furthest_ = -1;
      recorded_events_ = 0;
      told_incomplete_ = false;
      events_.clear();
      ++generation_;
      break;
    default:
      break;
  }
  next_time_ = {};
  playback_.handle(command);
}

bool RecordingRunner::pump() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!playback_.wantsFrame()) return false;
  const auto now = std::chrono::steady_clock::now();
  if (playback_.speed() > 0) {
    if (now < next_time_) return false;
    const auto interval =
        std::chrono::microseconds(static_cast<std::int64_t>(1e6 / playback_.speed()));
    next_time_ = (now - next_time_ > interval ? now : next_time_) +
                 interval;  // no catching up after a pause
  }
  if (row_ < lastRow()) goTo(row_ + 1);
  if (row_ >= lastRow()) playback_.finish();
  return true;
}

RunnerStatus RecordingRunner::status() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  RunnerStatus status;
  status.recorded = true;
  status.playing = playback_.playing();
  status.finished = row_ == lastRow();
  status.next_frame = row_ < 0 ? frameAt(0) : frameAt(row_) + 1;
  status.history_bytes = values_.bytes() + wholes_.bytes();
  status.history_budget = kValuesBudget + kImagesBudget;
  status.history_first = frameAt(0);
  return status;
}

SnapshotPtr RecordingRunner::values(int row) const {
  if (row < 0) return nullptr;
  if (const SnapshotPtr* held = values_.find(row)) return *held;
  auto read = file_->values(static_cast<std::size_t>(row));
  if (!read.ok()) events_.push_back({frameAt(row), EventKind::error, read.error().what});
  // Of a damaged frame its row is left.
  const SnapshotPtr snapshot =
      read.ok() ? std::move(read).value() : file_->rowOnly(static_cast<std::size_t>(row));
  values_.add(row, snapshot, snapshot->bytes);
  return snapshot;
}

SnapshotPtr RecordingRunner::whole(int row) const {
  if (row < 0) return nullptr;
  if (const SnapshotPtr* held = wholes_.find(row)) return *held;
  const SnapshotPtr without_image = values(row);
  auto snapshot = std::make_shared<Snapshot>(*without_image);
  snapshot->pyramid = file_->pyramid(frameAt(row));
  if (!snapshot->pyramid && file_->frames()[static_cast<std::size_t>(row)].readable)
    events_.push_back({frameAt(row), EventKind::error,
                       "the recording's image of this frame is missing or damaged"});
  std::size_t bytes = sizeof(Snapshot) + snapshot->features.size() * sizeof(FeatureView);
  if (snapshot->pyramid) {
    for (const cv::Mat& level : *snapshot->pyramid) bytes += level.total();
  }
  wholes_.add(row, snapshot, bytes);
  return snapshot;
}

SnapshotPtr RecordingRunner::latest() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return whole(row_);
}

SnapshotPtr RecordingRunner::at(int frame_index) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return whole(rowOf(frame_index));
}

SnapshotPtr RecordingRunner::valuesAt(int frame_index) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return values(rowOf(frame_index));
}

std::vector<FrameRecord> RecordingRunner::records(int first) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<FrameRecord> records;
  for (int row = std::max(first, 0); row <= furthest_; ++row)
    records.push_back(file_->frames()[static_cast<std::size_t>(row)].record);
  return records;
}

std::vector<Event> RecordingRunner::events(int first) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::size_t from = std::min(events_.size(), static_cast<std::size_t>(std::max(first, 0)));
  return {events_.begin() + static_cast<std::ptrdiff_t>(from), events_.end()};
}

std::vector<ParameterView> RecordingRunner::parameters() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return file_->parameters(row_ < 0 ? frameAt(0) : frameAt(row_));
}

int RecordingRunner::generation() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return generation_;
}

}  // namespace svoscope
