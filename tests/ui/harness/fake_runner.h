// SPDX-License-Identifier: MIT
// A synchronous runner without an engine: 20 frames, started at 5, a keyframe every tenth.
#pragma once

#include <string>
#include <vector>

#include "engine/runner/runner.h"

namespace svoscope::ui {

class FakeRunner : public Runner {
 public:
  static constexpr int kFrames = 20;
  std::string last_set;

  FakeRunner() { info_.frames = kFrames; }
  void send(const Command& command) override { commands_.push_back(command); }
  bool pump() override {
    for (const Command& command : commands_) apply(command);
    commands_.clear();
    if (!working_ || status_.finished) return false;
    process();
    return true;
  }
  const RunInfo& info() const override { return info_; }
  RunnerStatus status() const override { return status_; }
  SnapshotPtr latest() const override { return snapshots_.empty() ? nullptr : snapshots_.back(); }
  SnapshotPtr at(int frame) const override {
    return frame >= 0 && frame < static_cast<int>(snapshots_.size()) ? snapshots_[frame] : nullptr;
  }
  std::vector<FrameRecord> records(int first) const override {
    std::vector<FrameRecord> rows;
    for (std::size_t i = first; i < snapshots_.size(); ++i) rows.push_back(snapshots_[i]->record);
    return rows;
  }
  std::vector<Event> events(int) const override { return {}; }
  std::vector<ParameterView> parameters() const override {
    ParameterView parameter;
    parameter.key = "track.gain";
    return {parameter};
  }
  int generation() const override { return generation_; }

 private:
  using Kind = Command::Kind;
  void apply(const Command& command) {
    if (command.kind == Kind::set_parameter) {
      last_set = command.key + "=" + command.value;
    } else if (command.kind == Kind::reset) {
      snapshots_.clear();
      status_ = {};
      working_ = false;
      ++generation_;
    } else {
      goal_ = command;
      working_ = status_.playing = command.kind != Kind::pause;
    }
  }
  void process() {
    auto snapshot = std::make_shared<Snapshot>();
    FrameRecord& r = snapshot->record;
    r.index = status_.next_frame++;
    r.state = r.index < 5 ? TrackingState::initializing : TrackingState::tracking;
    r.reason = "as scripted";
    r.is_keyframe = r.index % 10 == 0;
    r.funnel.inliers = 100 + r.index;
    snapshots_.push_back(snapshot);
    status_.finished = status_.next_frame == kFrames;
    const bool reached = goal_.kind == Kind::step ||
                         (goal_.kind == Kind::run_to_frame && r.index >= goal_.frame) ||
                         (goal_.kind == Kind::run_to_keyframe && r.is_keyframe) ||
                         (goal_.kind == Kind::run_to_start && r.index >= 5);
    if (reached || status_.finished) working_ = status_.playing = false;
  }

  RunInfo info_;
  RunnerStatus status_;
  std::vector<Command> commands_;
  Command goal_;
  bool working_ = false;
  int generation_ = 0;
  std::vector<SnapshotPtr> snapshots_;
};

}  // namespace svoscope::ui
