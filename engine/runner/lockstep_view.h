// SPDX-License-Identifier: MIT
// One run of a LockstepRunner as others see it; internal to it.
#pragma once

#include <algorithm>
#include <atomic>

#include "engine/runner/run_view.h"

namespace svoscope {

/// A run as far as all others are: what it has beyond the common frame is not there yet.
class LockstepView : public RunView {
 public:
  LockstepView(const RunView& run, const std::atomic<int>& frame) : run_(run), frame_(frame) {}

  const RunInfo& info() const override { return run_.info(); }
  RunnerStatus status() const override {
    RunnerStatus status = run_.status();
    status.next_frame = std::min(status.next_frame, frame_ + 1);
    status.recorded = false;  // it goes where all go
    return status;
  }
  SnapshotPtr latest() const override {
    if (SnapshotPtr common = run_.at(frame_)) return common;
    SnapshotPtr newest = run_.latest();
    return newest && newest->record.index <= frame_ ? newest : nullptr;
  }
  SnapshotPtr at(int frame_index) const override {
    return frame_index <= frame_ ? run_.at(frame_index) : nullptr;
  }
  SnapshotPtr valuesAt(int frame_index) const override {
    return frame_index <= frame_ ? run_.valuesAt(frame_index) : nullptr;
  }
  std::vector<FrameRecord> records(int first) const override {
    std::vector<FrameRecord> rows = run_.records(first);
    while (!rows.empty() && rows.back().index > frame_) rows.pop_back();
    return rows;
  }
  std::vector<Event> events(int first) const override {
    std::vector<Event> events = run_.events(first);
    if (run_.status().next_frame <= frame_ + 1) return events;
    while (!events.empty() && events.back().frame_index > frame_) events.pop_back();
    return events;
  }
  std::vector<ParameterView> parameters() const override { return run_.parameters(); }
  int generation() const override { return run_.generation(); }

 private:
  const RunView& run_;
  const std::atomic<int>& frame_;
};

}  // namespace svoscope
