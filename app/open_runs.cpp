// SPDX-License-Identifier: MIT
#include "app/open_runs.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <limits>

#include "app/command.h"
#include "engine/dataset/shared_sequence.h"
#include "engine/recording/open_run.h"
#include "engine/runner/lockstep_runner.h"
#include "engine/runner/serialized_runner.h"
#include "engine/runner/trajectory_runner.h"

namespace svoscope {

namespace {

/// The one place where a recording becomes a run.
Result<std::unique_ptr<Runner>> openRecording(const std::string& path) {
  std::error_code ec;
  if (!std::filesystem::exists(path, ec))
    return inputError("does not exist", path, "check the path");
  if (!looksLikeRecording(path))
    return inputError("is not a recording", path, "run --record writes run.svoscope");
  return openRun(path, {});
}

/// A recording knows its frames' times; it is opened once more to be asked for them.
Result<FrameTimes> recordedTimes(const std::string& path) {
  auto runner = openRecording(path);
  if (!runner.ok()) return runner.error();
  Command to_end;
  to_end.kind = Command::Kind::run_to_frame;
  to_end.frame = std::numeric_limits<int>::max();
  runner.value()->send(to_end);
  while (runner.value()->pump()) {
  }
  FrameTimes times;
  for (const FrameRecord& record : runner.value()->records(0)) {
    if (times.timestamps.empty()) times.first = record.index;
    times.timestamps.push_back(record.timestamp);
  }
  return times;
}

FrameTimes frameTimes(const RunSettings& run, const Sequence& s) {
  FrameTimes times;
  times.first = run.start;
  const int end = run.max_frames < 0 ? s.size() : std::min(s.size(), run.start + run.max_frames);
  for (int i = run.start; i < end; ++i) times.timestamps.push_back(s.timestamp(i));
  return times;
}

class Opener {
 public:
  Opener(const RunSettings& run, const CompareSettings& compare, const RunnerOptions& options)
      : run_(run), compare_(compare), options_(options) {
    options_.history_budget /=
        std::max<std::size_t>(1, run.methods.size());  // recordings have a cache of their own
  }

  /// SEQUENCE itself: a run per method, or a recording.
  Status first() {
    if (!looksLikeRecording(run_.sequence)) return engines();
    auto runner = run_.open(options_);
    if (!runner.ok()) return runner.error();
    const std::string method = runner.value()->info().method;
    add(std::move(runner).value(), method, false);
    const auto times = recordedTimes(run_.sequence);
    if (!times.ok()) return times.error();
    times_ = times.value();
    return Done{};
  }

  Status engines() {
    const Result<Parameters> checked = run_.parameters();  // before a large sequence is opened
    if (!checked.ok()) return checked.error();
    auto opened = run_.openInput();
    if (!opened.ok()) return opened.error();
    const SequenceSharer sharer(std::move(opened).value());
    times_ = frameTimes(run_, *sharer.make());
    for (const std::string& method : run_.methods) {
      auto runner = run_.with(method).open(options_, sharer.make());
      if (!runner.ok()) return runner.error();
      add(std::move(runner).value(), method, false);
    }
    return Done{};
  }

  Status recordings() {
    for (const std::string& argument : compare_.recordings) {
      const auto [path, label] = splitLabel(argument);
      auto runner = openRecording(path);
      if (!runner.ok()) return runner.error();
      if (runner.value()->info().sequence != info().sequence) {
        return inputError(
            "it is a run of " + runner.value()->info().sequence + ", not of " + info().sequence,
            path, "runs are compared on one sequence");
      }
      add(std::move(runner).value(), label, false);
    }
    return Done{};
  }

  Status trajectories() {
    for (const std::string& argument : compare_.trajectories) {
      const auto [path, label] = splitLabel(argument);
      const auto file = loadTrajectory(path);
      if (!file.ok()) return file.error();
      for (const std::string& warning : file.value().warnings) reportWarning(path + ": " + warning);
      RunInfo of_file = info();
      of_file.method = label;
      auto runner = TrajectoryRunner::make(file.value(), times_, of_file, path);
      if (!runner.ok()) return runner.error();
      add(std::make_unique<SerializedRunner>(std::move(runner).value()), label, true);
    }
    return Done{};
  }

  std::unique_ptr<Runner> finish() {
    const auto drive =
        options_.threaded ? LockstepRunner::Drive::by_thread : LockstepRunner::Drive::by_pump;
    return std::make_unique<LockstepRunner>(std::move(members_), drive);
  }

 private:
  const RunInfo& info() const { return members_.front().runner->info(); }

  /// Labels are unique: "orb", "orb 2", ...
  void add(std::unique_ptr<Runner> runner, const std::string& wanted, bool poses_only) {
    std::string label = wanted;
    const auto taken = [&](const LockstepMember& m) { return m.label == label; };
    for (int n = 2; std::any_of(members_.begin(), members_.end(), taken); ++n) {
      label = wanted + " " + std::to_string(n);
    }
    members_.push_back({std::move(runner), label, poses_only});
  }

  const RunSettings& run_;
  const CompareSettings& compare_;
  RunnerOptions options_;
  FrameTimes times_;
  std::vector<LockstepMember> members_;
};

}  // namespace

void CompareSettings::addTo(CLI::App& command) {
  command
      .add_option("--with", recordings,
                  "A recording of the same sequence as one more run; repeatable")
      ->allow_extra_args(false)
      ->type_name("RUN[=LABEL]");
  command
      .add_option("--trajectory", trajectories,
                  "Poses of another system (TUM, EuRoC CSV, KITTI) to compare with; repeatable")
      ->allow_extra_args(false)
      ->type_name("FILE[=LABEL]");
}

std::pair<std::string, std::string> splitLabel(const std::string& argument) {
  const auto equals = argument.rfind('=');
  const bool labelled = equals != std::string::npos && equals > 0 && equals + 1 < argument.size() &&
                        argument.find('/', equals) == std::string::npos;
  if (labelled) return {argument.substr(0, equals), argument.substr(equals + 1)};
  return {argument, std::filesystem::path(argument).stem().string()};
}

Result<std::unique_ptr<Runner>> openRuns(const RunSettings& run, const CompareSettings& compare,
                                         const RunnerOptions& options) {
  const bool alone =
      run.methods.size() == 1 && compare.recordings.empty() && compare.trajectories.empty();
  if (alone) return run.open(options);
  Opener opener(run, compare, options);
  Status status = opener.first();
  if (status.ok()) status = opener.recordings();
  if (status.ok()) status = opener.trajectories();
  if (!status.ok()) return status.error();
  return opener.finish();
}

}  // namespace svoscope
