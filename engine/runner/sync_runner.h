// SPDX-License-Identifier: MIT
// Everything in the caller's thread, mapping completed after every frame: bit-identical from run
// to run.
#pragma once

#include <deque>

#include "engine/runner/make_runner.h"
#include "engine/runner/publish.h"

namespace svoscope {

class SyncRunner : public Runner {
 public:
  SyncRunner(std::unique_ptr<Sequence> sequence, const RunnerOptions& options);

  void send(const Command& command) override { commands_.push_back(command); }
  bool pump() override;
  const RunInfo& info() const override { return engine_.info(); }
  RunnerStatus status() const override;
  SnapshotPtr latest() const override { return log_.latest(); }
  SnapshotPtr at(int frame_index) const override { return log_.at(frame_index); }
  std::vector<FrameRecord> records(int first) const override { return log_.records(first); }
  std::vector<Event> events(int first) const override { return log_.events(first); }
  std::vector<ParameterView> parameters() const override {
    return listParameters(engine_.parameters());
  }
  int generation() const override { return log_.generation(); }

 private:
  void processFrame();
  RunParts parts() { return {engine_, playback_, log_, publish_}; }

  Engine engine_;
  RunLog log_;
  Playback playback_;
  std::deque<Command> commands_;
  bool publish_;
  FrameRate rate_;
};

}  // namespace svoscope
