// SPDX-License-Identifier: MIT
#include "engine/runner/run_log.h"

#include <algorithm>

namespace svoscope {

void RunLog::begin(const RunInfo& info) {
  if (observer_) observer_->begin(info);
}

void RunLog::parameters(const std::vector<ParameterView>& parameters, int from) {
  if (observer_) observer_->parameters(parameters, from);
}

void RunLog::addNote(const Event& event) {
  if (observer_) observer_->note(event);
  addEvents({event});
}

void RunLog::addRecord(const FrameRecord& record) {
  const std::lock_guard<std::mutex> lock(mutex_);
  records_.push_back(record);
}

void RunLog::addEvents(const std::vector<Event>& events) {
  const std::lock_guard<std::mutex> lock(mutex_);
  events_.insert(events_.end(), events.begin(), events.end());
}

void RunLog::addSnapshot(SnapshotPtr snapshot) {
  if (observer_) observer_->frame(snapshot);
  std::vector<SnapshotPtr> evicted;  // destroyed outside the lock
  const std::lock_guard<std::mutex> lock(mutex_);
  bytes_ += snapshot->bytes;
  history_.push_back(std::move(snapshot));
  while (bytes_ > budget_ && history_.size() > 1) {
    bytes_ -= history_.front()->bytes;
    evicted.push_back(std::move(history_.front()));
    history_.pop_front();
  }
}

void RunLog::clear() {
  if (observer_) observer_->reset();
  std::deque<SnapshotPtr> dropped;
  const std::lock_guard<std::mutex> lock(mutex_);
  dropped.swap(history_);
  records_.clear();
  events_.clear();
  bytes_ = 0;
  ++generation_;
}

SnapshotPtr RunLog::latest() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return history_.empty() ? nullptr : history_.back();
}

SnapshotPtr RunLog::at(int frame_index) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto it =
      std::lower_bound(history_.begin(), history_.end(), frame_index,
                       [](const SnapshotPtr& s, int index) { return s->record.index < index; });
  return it != history_.end() && (*it)->record.index == frame_index ? *it : nullptr;
}

std::vector<FrameRecord> RunLog::records(int first) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::size_t from = std::min(records_.size(), static_cast<std::size_t>(std::max(first, 0)));
  return {records_.begin() + static_cast<std::ptrdiff_t>(from), records_.end()};
}

std::vector<Event> RunLog::events(int first) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::size_t from = std::min(events_.size(), static_cast<std::size_t>(std::max(first, 0)));
  return {events_.begin() + static_cast<std::ptrdiff_t>(from), events_.end()};
}

int RunLog::generation() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return generation_;
}

void RunLog::describe(RunnerStatus& status) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  status.history_bytes = bytes_;
  status.history_budget = budget_;
  status.history_first = history_.empty() ? 0 : history_.front()->record.index;
}

}  // namespace svoscope
