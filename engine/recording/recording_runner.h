// SPDX-License-Identifier: MIT
// Plays a recording back as if the engine ran: frames come by step, play and run_to_*, rows and
// events up to the furthest frame that was reached. Nothing is computed, so run_to_* jumps,
// run_to_frame backwards too; at() reaches every frame of the recording at any time. Parameters
// cannot be set: the wish becomes a warning event.
#pragma once

#include <chrono>
#include <mutex>

#include "engine/recording/lru_cache.h"
#include "engine/recording/recording_file.h"
#include "engine/runner/playback.h"

namespace svoscope {

class RecordingRunner : public Runner {
 public:
  explicit RecordingRunner(std::unique_ptr<RecordingFile> file);

  void send(const Command& command) override;
  /// Playing: goes on by a frame if its time has come.
  bool pump() override;
  const RunInfo& info() const override { return file_->run().info; }
  RunnerStatus status() const override;
  SnapshotPtr latest() const override;
  SnapshotPtr at(int frame_index) const override;
  SnapshotPtr valuesAt(int frame_index) const override;
  std::vector<FrameRecord> records(int first) const override;
  std::vector<Event> events(int first) const override;
  std::vector<ParameterView> parameters() const override;
  int generation() const override;

 private:
  using FrameRow = RecordingFile::FrameRow;

  int rowOf(int frame_index) const;  ///< -1 if the recording has no such frame
  void goTo(int row);
  int nextRow(const Command& command) const;
  int frameAt(int row) const { return file_->frames()[static_cast<std::size_t>(row)].record.index; }
  int lastRow() const { return static_cast<int>(file_->frames().size()) - 1; }
  bool startsAt(int row) const;
  SnapshotPtr values(int row) const;
  SnapshotPtr whole(int row) const;

  mutable std::mutex mutex_;  ///< guards everything below
  const std::unique_ptr<RecordingFile> file_;
  mutable LruCache<SnapshotPtr> values_, wholes_;
  Playback playback_;
  int row_ = -1;       ///< reached now; -1: before the first
  int furthest_ = -1;  ///< reached since the last reset
  bool told_incomplete_ = false;
  std::size_t recorded_events_ = 0;    ///< of the file, published
  mutable std::vector<Event> events_;  ///< published
  int generation_ = 0;
  std::chrono::steady_clock::time_point next_time_{};
};

}  // namespace svoscope
