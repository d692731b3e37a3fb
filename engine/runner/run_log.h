// SPDX-License-Identifier: MIT
// What a run has published so far: rows, events, and snapshots within a byte budget. All members
// may be called from any thread.
#pragma once

#include <deque>
#include <mutex>

#include "engine/runner/run_observer.h"

namespace svoscope {

class RunLog {
 public:
  explicit RunLog(std::size_t byte_budget, std::shared_ptr<RunObserver> observer = nullptr)
      : budget_(byte_budget), observer_(std::move(observer)) {}

  /// Tells the observer, if there is one; the log itself keeps neither.
  void begin(const RunInfo& info);
  void parameters(const std::vector<ParameterView>& parameters, int from);

  void addRecord(const FrameRecord& record);
  void addEvents(const std::vector<Event>& events);
  /// An event that is in no snapshot.
  void addNote(const Event& event);
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
  const std::shared_ptr<RunObserver> observer_;  ///< sees all that is published; may be null
  std::size_t bytes_ = 0;
  std::deque<SnapshotPtr> history_;
  std::vector<FrameRecord> records_;
  std::vector<Event> events_;
  int generation_ = 0;
};

}  // namespace svoscope
