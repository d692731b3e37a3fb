// SPDX-License-Identifier: MIT
// Lets several threads call a runner that was made for one: every call waits for the one before.
#pragma once

#include <memory>
#include <mutex>

#include "engine/runner/runner.h"

namespace svoscope {

class SerializedRunner : public Runner {
 public:
  explicit SerializedRunner(std::unique_ptr<Runner> runner)
      : runner_(std::move(runner)), info_(runner_->info()) {}

  void send(const Command& command) override { locked(), runner_->send(command); }
  bool pump() override { return locked(), runner_->pump(); }
  const RunInfo& info() const override { return info_; }
  RunnerStatus status() const override { return locked(), runner_->status(); }
  SnapshotPtr latest() const override { return locked(), runner_->latest(); }
  SnapshotPtr at(int frame_index) const override { return locked(), runner_->at(frame_index); }
  SnapshotPtr valuesAt(int frame_index) const override {
    return locked(), runner_->valuesAt(frame_index);
  }
  std::vector<FrameRecord> records(int first) const override {
    return locked(), runner_->records(first);
  }
  std::vector<Event> events(int first) const override { return locked(), runner_->events(first); }
  std::vector<ParameterView> parameters() const override { return locked(), runner_->parameters(); }
  int generation() const override { return locked(), runner_->generation(); }

 private:
  /// Held to the end of the full expression it stands in.
  std::unique_lock<std::mutex> locked() const { return std::unique_lock<std::mutex>(mutex_); }

  mutable std::mutex mutex_;
  std::unique_ptr<Runner> runner_;
  const RunInfo info_;
};

}  // namespace svoscope
