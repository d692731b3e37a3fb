// SPDX-License-Identifier: MIT
// Several runs on one sequence, moved from frame to frame together. To whoever drives it, it looks
// like one runner: commands go to all runs, answers are those of the current one.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "engine/base/stopwatch.h"
#include "engine/runner/playback.h"
#include "engine/runner/runner.h"

namespace svoscope {

class LockstepView;

struct LockstepMember {
  std::unique_ptr<Runner> runner;
  std::string label;        ///< unique, as shown and as named in scripts: "it-svo", "orb"
  bool poses_only = false;  ///< a trajectory: nothing to inspect, it cannot become the current run
};

/// The runs take turns: while one tracks a frame the others wait, so that on few cores their times
/// stay comparable to those of a run alone. A frame counts once the last run has it; before, no one
/// sees anything of it. A run that ended, or that begins later, sits the frame out.
///
/// "Run to keyframe", "to loss" and "to start" are goals of the current run, parameters are set in
/// the current run; everything else concerns all.
class LockstepRunner : public Runner {
 public:
  enum class Drive {
    by_pump,    ///< work is done in pump(): the same result every time
    by_thread,  ///< by a thread of its own; members must allow calls from several threads
  };
  /// At least one member that is not poses_only.
  LockstepRunner(std::vector<LockstepMember> members, Drive drive);
  ~LockstepRunner() override;

  int size() const { return static_cast<int>(members_.size()); }
  const std::string& label(int i) const { return member(i).label; }
  bool posesOnly(int i) const { return member(i).poses_only; }
  int current() const { return current_; }
  /// Usage error if there is no such run or it has poses only.
  Status setCurrent(int i);
  /// Last frame that all runs went through; -1 before the first.
  int frame() const { return frame_; }
  /// One run, up to frame(). Valid as long as this object.
  const RunView& run(int i) const;

  void send(const Command& command) override;
  bool pump() override;
  const RunInfo& info() const override { return run(current_).info(); }
  RunnerStatus status() const override;
  SnapshotPtr latest() const override { return run(current_).latest(); }
  SnapshotPtr at(int frame_index) const override { return run(current_).at(frame_index); }
  SnapshotPtr valuesAt(int frame_index) const override {
    return run(current_).valuesAt(frame_index);
  }
  std::vector<FrameRecord> records(int first) const override {
    return run(current_).records(first);
  }
  std::vector<Event> events(int first) const override { return run(current_).events(first); }
  std::vector<ParameterView> parameters() const override { return run(current_).parameters(); }
  /// Of the set: increases when all runs were reset.
  int generation() const override { return generation_; }

 private:
  struct Member : LockstepMember {
    std::unique_ptr<LockstepView> view;
    int rows_seen = 0;
    int generation_before = 0;  ///< the reset that is under way
    bool ended = false;         ///< it stopped by itself before the end
    TrackingState state = TrackingState::initializing;
  };

  const Member& member(int i) const { return members_[static_cast<std::size_t>(i)]; }
  bool advance();
  bool takeCommands();
  void handle(const Command& command);
  bool finishReset();
  bool beginFrame();
  bool due();
  void endFrame();
  bool behind(const Member& member) const;
  bool gaveUp(Member& member, bool worked);
  bool atRest() const;
  void publish();
  void loop();

  std::vector<Member> members_;
  std::atomic<int> current_{0}, frame_{-1}, generation_{0};

  // Of whoever advances: pump() or the thread.
  Playback playback_;
  int target_ = 0;      ///< frame being processed
  int turn_ = -1;       ///< whose turn it is; -1: all have the same frame
  bool asked_ = false;  ///< whose turn it is knows about it
  bool resetting_ = false;
  double idle_since_ms_ = 0;
  Stopwatch clock_;
  std::chrono::steady_clock::time_point next_time_{};

  mutable std::mutex mutex_;  ///< guards the members below
  std::condition_variable wake_;
  std::deque<Command> commands_;
  bool stop_ = false, playing_ = false, finished_ = false;
  int next_frame_ = 0;

  std::thread thread_;
};

}  // namespace svoscope
