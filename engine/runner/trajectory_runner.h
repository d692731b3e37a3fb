// SPDX-License-Identifier: MIT
// A trajectory from a file as a run: one row per frame of a sequence, with the pose of that time
// where the file has one. For comparing with systems of which nothing but the poses is known.
#pragma once

#include <deque>
#include <memory>
#include <vector>

#include "engine/base/result.h"
#include "engine/eval/trajectory_file.h"
#include "engine/runner/playback.h"
#include "engine/runner/run_log.h"
#include "engine/runner/runner.h"

namespace svoscope {

/// What a trajectory is laid over.
struct FrameTimes {
  int first = 0;                   ///< index of the first frame in the sequence
  std::vector<double> timestamps;  ///< s, increasing, one per frame
};

/// A pose belongs to the frame nearest in time, at most this far away; seconds.
constexpr double kPoseFrameMaxDt = 0.02;

class TrajectoryRunner : public Runner {
 public:
  /// `info` names sequence, label (as method), camera and ground truth. Rows without timestamps
  /// (KITTI) are those of the sequence's frames in order, from frame 0. Input error, naming
  /// `where`, if no pose belongs to a frame.
  static Result<std::unique_ptr<Runner>> make(const TrajectoryFile& file, const FrameTimes& frames,
                                              RunInfo info, const std::string& where);

  void send(const Command& command) override { commands_.push_back(command); }
  bool pump() override;
  const RunInfo& info() const override { return info_; }
  RunnerStatus status() const override;
  SnapshotPtr latest() const override { return log_.latest(); }
  SnapshotPtr at(int frame_index) const override { return log_.at(frame_index); }
  std::vector<FrameRecord> records(int first) const override { return log_.records(first); }
  std::vector<Event> events(int first) const override { return log_.events(first); }
  std::vector<ParameterView> parameters() const override { return {}; }
  int generation() const override { return log_.generation(); }

 private:
  TrajectoryRunner(std::vector<FrameRecord> rows, RunInfo info);

  const std::vector<FrameRecord> rows_;
  RunInfo info_;
  RunLog log_;
  Playback playback_;
  std::deque<Command> commands_;
  std::size_t next_ = 0;
  std::uint64_t published_ = 0;
};

}  // namespace svoscope
