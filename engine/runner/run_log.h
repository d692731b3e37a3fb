// SPDX-License-Identifier: MIT
// What a run has published so far: rows, events, and snapshots within a byte budget. All members
// may be called from any thread.
#pragma once

#include <deque>
#include <mutex>

#include "engine/runner/runner.h"

namespace svoscope {

class RunLog {
 public:
  explicit RunLog(std::size_t byte_budget) : budget_(byte_budget) {}

  void addRecord(const FrameRecord& record);
  void addEvents(const std::vector<Event>& events);
  /// Publishes; the oldest snapshots are dropped once the budget is exceeded.
  void addSnapshot(SnapshotPtr snapshot);
  void clear();

  SnapshotPtr latest() const;
  SnapshotPtr at(int frame_index) const;
  std::vector<FrameRecord> records(int first) const;
  std::vector<Event> events(int first) const;
  int generation() const;
  /// Fills the history fields of a status.
  void describe(RunnerStatus& status) const;

 private:
  mutable std::mutex mutex_;
  const std::size_t budget_;
  std::size_t bytes_ = 0;
  std::deque<SnapshotPtr> history_;
  std::vector<FrameRecord> records_;
  std::vector<Event> events_;
  int generation_ = 0;
};

}  // namespace svoscope
