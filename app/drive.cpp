// SPDX-License-Identifier: MIT
#include "app/drive.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace svoscope {

namespace {

constexpr auto kIdle = std::chrono::milliseconds(2);
// An engine that neither plays nor finishes for this long will not go on by itself.
constexpr double kStuckMs = 2000;

Command commandOf(Command::Kind kind, const std::string& value = "") {
  Command command;
  command.kind = kind;
  command.value = value;
  return command;
}

class Driver {
 public:
  Driver(Runner& runner, RunWriter& writer, const DriveOptions& options)
      : runner_(runner), writer_(writer), options_(options) {}

  Result<DriveOutcome> run() {
    runner_.send(commandOf(Command::Kind::set_speed, "0"));
    runner_.send(commandOf(Command::Kind::play));
    while (true) {
      const bool worked = runner_.pump();
      if (options_.stop && *options_.stop && !outcome_.interrupted) {
        outcome_.interrupted = true;
        runner_.send(commandOf(Command::Kind::pause));
      }
      const RunnerStatus status = runner_.status();  // before the rows: they are complete then
      const auto progressed = drain(status);
      if (!progressed.ok()) return progressed.error();
      if (worked || progressed.value()) idle_since_ = watch_.ms();
      if (ended(status)) break;
      if (!worked) std::this_thread::sleep_for(kIdle);
    }
    const int next_frame = runner_.status().next_frame;
    outcome_.frames =
        std::max(static_cast<int>(writer_.records().size()), next_frame - options_.first_frame);
    return outcome_;
  }

 private:
  /// Writes the new frames; true if there were any.
  Result<bool> drain(const RunnerStatus& status) {
    const auto records = runner_.records(records_seen_);
    for (const FrameRecord& record : records) {
      const Status written = writer_.frame(record);
      if (!written.ok()) return written.error();
      if (const SnapshotPtr snapshot = runner_.at(record.index)) writer_.observe(*snapshot);
      if (options_.progress) options_.progress(record, status);
    }
    records_seen_ += static_cast<int>(records.size());
    const auto events = runner_.events(events_seen_);
    for (const Event& event : events) {
      if (event.kind == EventKind::warning) outcome_.warnings.push_back(text(event));
      if (event.kind == EventKind::error) outcome_.errors.push_back(text(event));
    }
    events_seen_ += static_cast<int>(events.size());
    return !records.empty();
  }

  bool ended(const RunnerStatus& status) {
    if (status.finished) return status.mapping_queue == 0;
    if (status.playing) return false;
    // "play" and "pause" take effect between frames: a pause that was asked for ends the run at
    // once, any other only if nothing moves.
    if (outcome_.interrupted) return status.mapping_queue == 0;
    if (watch_.ms() - idle_since_ < kStuckMs) return false;
    if (outcome_.errors.empty()) outcome_.errors.push_back("the engine stopped before the end");
    return true;
  }

  static std::string text(const Event& event) {
    return event.frame_index < 0 ? event.text
                                 : "frame " + std::to_string(event.frame_index) + ": " + event.text;
  }

  Runner& runner_;
  RunWriter& writer_;
  const DriveOptions& options_;
  DriveOutcome outcome_;
  Stopwatch watch_;
  double idle_since_ = 0;
  int records_seen_ = 0, events_seen_ = 0;
};

}  // namespace

Result<DriveOutcome> drive(Runner& runner, RunWriter& writer, const DriveOptions& options) {
  return Driver(runner, writer, options).run();
}

}  // namespace svoscope
