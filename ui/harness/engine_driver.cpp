// SPDX-License-Identifier: MIT
#include "ui/harness/engine_driver.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <functional>
#include <thread>

#include "engine/base/stopwatch.h"

namespace svoscope::ui {
namespace {

constexpr double kIdleMs = 3000;     // paused and nothing happens: it stopped
constexpr double kStuckMs = 300000;  // busy, but no frame in five minutes

/// Lets the engine work until `done`, or until it stays paused without a new frame.
void workUntil(Runner& runner, const std::function<bool(const RunnerStatus&)>& done) {
  Stopwatch since_progress;
  int frame = runner.status().next_frame;
  for (;;) {
    const bool processed = runner.pump();
    const RunnerStatus status = runner.status();
    if (done(status)) return;
    if (status.next_frame != frame) {
      frame = status.next_frame;
      since_progress = Stopwatch();
    }
    if (since_progress.ms() > (status.playing ? kStuckMs : kIdleMs)) return;
    if (!processed) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

/// A frame counts as processed a moment before its snapshot can be had.
void awaitSnapshot(Runner& runner) {
  const auto current = [&] {
    const SnapshotPtr latest = runner.latest();
    return latest && latest->record.index + 1 >= runner.status().next_frame;
  };
  for (Stopwatch watch; !current() && watch.ms() < 1000;) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

/// "lost: too few matches"; a reason that only names the state adds nothing.
std::string stateText(const FrameRecord& record) {
  const std::string state = stateName(record.state);
  return record.reason.empty() || record.reason == state ? state : state + ": " + record.reason;
}

std::string whereNow(const RunView& runner) {
  const RunnerStatus status = runner.status();
  std::string text = "after frame " + std::to_string(status.next_frame - 1);
  if (const SnapshotPtr latest = runner.latest()) text += " (" + stateText(latest->record) + ")";
  return text;
}

Error ended(const RunView& runner, const std::string& wanted) {
  return Error{ErrorKind::internal,
               (runner.status().finished ? "the sequence ended " : "the engine paused ") +
                   whereNow(runner) + " without " + wanted,
               "", ""};
}

struct Goal {
  Command::Kind kind;
  const char* wanted;
  bool (*reached)(const FrameRecord&);
};

const Goal* findGoal(const std::string& name) {
  static const Goal keyframe{Command::Kind::run_to_keyframe, "a keyframe",
                             [](const FrameRecord& r) { return r.is_keyframe; }};
  static const Goal lost{Command::Kind::run_to_loss, "losing track",
                         [](const FrameRecord& r) { return r.state == TrackingState::lost; }};
  static const Goal start{Command::Kind::run_to_start, "a start", [](const FrameRecord& r) {
                            return r.state != TrackingState::initializing;
                          }};
  if (name == "keyframe") return &keyframe;
  if (name == "lost") return &lost;
  if (name == "start") return &start;
  return nullptr;
}

Status runToGoal(Runner& runner, const Goal& goal) {
  const int before = runner.status().next_frame;
  Command command;
  command.kind = goal.kind;
  runner.send(command);
  // The thread may take up the command late: "not playing" counts only after a frame.
  workUntil(runner, [&](const RunnerStatus& s) {
    return s.finished || (s.next_frame > before && !s.playing);
  });
  awaitSnapshot(runner);
  const SnapshotPtr latest = runner.latest();
  if (latest && runner.status().next_frame > before && goal.reached(latest->record)) return Done{};
  return ended(runner, goal.wanted);
}

Status runToFrame(Runner& runner, int frame) {
  if (frame < runner.status().next_frame) return Done{};
  Command command;
  command.kind = Command::Kind::run_to_frame;
  command.frame = frame;
  runner.send(command);
  workUntil(runner, [&](const RunnerStatus& s) {
    return s.finished || (s.next_frame > frame && !s.playing);
  });
  awaitSnapshot(runner);
  if (runner.status().next_frame > frame) return Done{};
  return ended(runner, "frame " + std::to_string(frame));
}

}  // namespace

Status stepFrames(Runner& runner, int frames) {
  for (int i = 0; i < frames; ++i) {
    const RunnerStatus before = runner.status();
    if (before.finished) return ended(runner, "another frame");
    runner.send(Command{});
    workUntil(runner, [&](const RunnerStatus& s) {
      return s.finished || s.next_frame > before.next_frame;
    });
    if (runner.status().next_frame <= before.next_frame) return ended(runner, "another frame");
  }
  awaitSnapshot(runner);
  return Done{};
}

Status runUntil(Runner& runner, const std::string& until) {
  if (const Goal* goal = findGoal(until)) return runToGoal(runner, *goal);
  const bool number =
      !until.empty() && until.size() < 9 &&
      std::all_of(until.begin(), until.end(), [](unsigned char c) { return std::isdigit(c); });
  if (number) return runToFrame(runner, std::stoi(until));
  return usageError("cannot run to '" + until + "'", "",
                    "known: keyframe, lost, start, or a frame");
}

Status resetRun(Runner& runner) {
  const int before = runner.generation();
  Command command;
  command.kind = Command::Kind::reset;
  runner.send(command);
  workUntil(runner, [&](const RunnerStatus&) { return runner.generation() != before; });
  if (runner.generation() != before) return Done{};
  return Error{ErrorKind::internal, "the engine did not start again", "", ""};
}

}  // namespace svoscope::ui
