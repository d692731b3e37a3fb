// SPDX-License-Identifier: MIT
// Small recorded runs for tests, and the snapshots that were handed to the recorder.
#pragma once

#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "engine/recording/open_run.h"
#include "engine/recording/recorder.h"
#include "tests/support/memory_sequence.h"
#include "tests/support/support.h"

namespace svoscope::test {

/// Passes everything on to a recorder and keeps the snapshots.
class KeepingObserver : public RunObserver {
 public:
  explicit KeepingObserver(std::shared_ptr<Recorder> recorder) : recorder_(std::move(recorder)) {}
  void begin(const RunInfo& info) override { recorder_->begin(info); }
  void parameters(const std::vector<ParameterView>& p, int from) override {
    recorder_->parameters(p, from);
  }
  void frame(const SnapshotPtr& s) override {
    snapshots.push_back(s);
    recorder_->frame(s);
  }
  void note(const Event& e) override { recorder_->note(e); }
  void reset() override {
    snapshots.clear();
    recorder_->reset();
  }
  std::vector<SnapshotPtr> snapshots;

 private:
  std::shared_ptr<Recorder> recorder_;
};

/// A run that is being recorded into a temporary folder.
struct RecordedRun {
  explicit RecordedRun(const std::string& spec, RunnerOptions options = {},
                       std::set<int> unreadable = {})
      : recorder(std::make_shared<Recorder>()), kept(std::make_shared<KeepingObserver>(recorder)) {
    options.observer = kept;
    auto sequence =
        std::make_unique<ChangedSequence>(openBuiltIn(spec), nullptr, std::move(unreadable));
    runner = std::move(makeRunner(std::move(sequence), options).value());
    started = recorder->start(file(), {"test", 95});
  }

  std::filesystem::path file() const { return folder / kRecordingName; }

  void send(Command::Kind kind, int frame = -1, const std::string& key = "",
            const std::string& value = "") {
    runner->send({kind, frame, key, value});
    while (runner->pump() || runner->status().playing) std::this_thread::yield();
  }
  /// Plays to the end and closes the recording.
  Status finish() {
    send(Command::Kind::play);
    return recorder->close();
  }
  std::unique_ptr<Runner> open() const {
    auto opened = openRun(file().string(), {});
    return opened.ok() ? std::move(opened).value() : nullptr;
  }

  TemporaryFolder folder;
  std::shared_ptr<Recorder> recorder;
  std::shared_ptr<KeepingObserver> kept;
  std::unique_ptr<Runner> runner;
  Status started = Done{};
};

inline RunnerOptions synchronous(const std::string& method) {
  RunnerOptions options;
  options.threaded = false;
  options.method = method;
  return options;
}

}  // namespace svoscope::test
