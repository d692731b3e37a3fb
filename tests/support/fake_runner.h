// SPDX-License-Identifier: MIT
// A runner without an engine that hands out the snapshots of a FakeWorld, for tests and pictures of
// the UI.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "engine/runner/runner.h"
#include "tests/support/fake_world.h"

namespace svoscope {

class FakeRunner : public Runner {
 public:
  explicit FakeRunner(const FakeOptions& options = {});

  void send(const Command& command) override;
  bool pump() override;
  const RunInfo& info() const override { return world_.info(); }
  RunnerStatus status() const override;
  SnapshotPtr latest() const override { return history_.empty() ? nullptr : history_.back(); }
  SnapshotPtr at(int frame_index) const override;
  std::vector<FrameRecord> records(int first) const override;
  std::vector<Event> events(int first) const override;
  std::vector<ParameterView> parameters() const override { return parameters_; }
  int generation() const override { return generation_; }

  /// Processes frames until `frames` were done.
  void runTo(int frames);
  const std::vector<Command>& sent() const { return sent_; }

 private:
  void makeParameters();
  void process();

  FakeOptions options_;
  FakeWorld world_;
  std::deque<SnapshotPtr> history_;
  std::vector<FrameRecord> records_;
  std::vector<Event> events_;
  std::vector<ParameterView> parameters_;
  std::vector<Command> sent_;
  bool playing_ = false;
  int pending_steps_ = 0, generation_ = 1, stop_after_ = -1;
  std::uint64_t sequence_ = 0;
  Command::Kind run_to_ = Command::Kind::pause;
};

}  // namespace svoscope
