// SPDX-License-Identifier: MIT
// svoscope run: a sequence from the first to the last frame, results into a folder.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/command.h"
#include "app/drive.h"
#include "app/interrupt.h"
#include "app/progress.h"
#include "engine/runner/make_runner.h"
#include "engine/runner/parameters.h"

namespace svoscope {

namespace {

constexpr const char* kFooter =
    "Writes trajectory.txt, keyframes.txt, frames.csv, map.ply, metrics.json and config.yaml into\n"
    "DIR (docs/commands.md). Ctrl-C writes what is done and exits with 130.\n"
    "\n"
    "Examples:\n"
    "  svoscope run synthetic:room --out results\n"
    "  svoscope run SEQUENCE --method svo --sync --out results\n"
    "  svoscope run SEQUENCE --config mine.yaml --set detect.cell_px=25 --out results";

struct Arguments {
  std::string sequence, out, config;
  std::string method = "svo";
  std::vector<std::string> settings;  ///< "key=value"
  bool sync = false;
  int start = 0;
  int max_frames = -1;
};

/// A bad disk gives a warning per frame: the first few say enough.
void reportBatched(const std::vector<std::string>& warnings) {
  constexpr std::size_t kShown = 3;
  for (std::size_t i = 0; i < std::min(kShown, warnings.size()); ++i) reportWarning(warnings[i]);
  if (warnings.size() > kShown) {
    reportWarning(fmt::format("{} more like these", warnings.size() - kShown));
  }
}

void showProgress(Progress& progress, const FrameRecord& record, const RunnerStatus& status,
                  int last_frame) {
  progress.show(fmt::format("frame {}/{}  {}  {} inliers, {} keyframes, {:.1f} frames/s",
                            record.index + 1, last_frame, stateName(record.state),
                            record.funnel.inliers, record.keyframes, status.fps));
}

int exitCodeOf(const DriveOutcome& outcome, const RunMetrics& metrics) {
  if (outcome.interrupted) return kExitInterrupted;
  if (!outcome.errors.empty()) return static_cast<int>(ErrorKind::internal);
  return metrics.init_frame ? kExitDone : kExitNeverInitialised;
}

int driveAndReport(Runner& runner, const Arguments& arguments, const std::string& config_yaml) {
  RunWriter writer;
  const Status begun = writer.begin(arguments.out, runner.info(), config_yaml);
  if (!begun.ok()) return reportError(begun.error());

  const InterruptGuard guard;
  DriveOptions options;
  options.first_frame = arguments.start;
  options.stop = &guard.flag();
  int last_frame = runner.info().frames;
  if (arguments.max_frames > 0) {
    last_frame = std::min(last_frame, arguments.start + arguments.max_frames);
  }
  Result<DriveOutcome> driven = DriveOutcome();
  {
    Progress progress;
    options.progress = [&](const FrameRecord& record, const RunnerStatus& status) {
      showProgress(progress, record, status, last_frame);
    };
    driven = drive(runner, writer, options);
  }
  if (!driven.ok()) return reportError(driven.error());
  const DriveOutcome& outcome = driven.value();
  reportBatched(outcome.warnings);
  for (const std::string& text : outcome.errors) {
    reportError({ErrorKind::internal, text, "engine", "what was done is written"});
  }
  const auto metrics = writer.finish(runner.latest(), outcome.frames);
  if (!metrics.ok()) return reportError(metrics.error());
  if (outcome.interrupted) reportWarning("interrupted; what was done is written");
  fmt::print("{} on {}\n{}files       {}\n", runner.info().method, runner.info().sequence,
             metricsText(metrics.value()), writer.folder().string());
  return exitCodeOf(outcome, metrics.value());
}

Status applySettings(const Arguments& arguments, Parameters& parameters) {
  if (!arguments.config.empty()) {
    const Status loaded = loadParameters(parameters, arguments.config);
    if (!loaded.ok()) return loaded;
  }
  for (const std::string& setting : arguments.settings) {
    const auto equals = setting.find('=');
    if (equals == std::string::npos || equals == 0) {
      return usageError("'" + setting + "' is not key=value", "--set", "as in --set key=value");
    }
    const Status set =
        setParameter(parameters, setting.substr(0, equals), setting.substr(equals + 1));
    if (!set.ok()) {
      Error error = set.error();
      error.kind = ErrorKind::usage;  // a key of the command line, not of a file
      return error;
    }
  }
  return Done{};
}

int runRun(const Arguments& arguments) {
  RunnerOptions options;
  const Status set = applySettings(arguments, options.parameters);
  if (!set.ok()) return reportError(set.error());
  auto sequence = openSequence(arguments.sequence);
  if (!sequence.ok()) return reportError(sequence.error());
  if (arguments.start >= sequence.value()->size()) {
    return reportError(
        usageError(fmt::format("the sequence has only {} frames", sequence.value()->size()),
                   fmt::format("--start {}", arguments.start), "give a smaller number"));
  }
  options.method = arguments.method;
  options.threaded = !arguments.sync;
  options.start = arguments.start;
  options.max_frames = arguments.max_frames;
  options.publish_snapshots = false;  // nobody looks at them
  const std::string config =
      "# svoscope " SVOSCOPE_VERSION "\n" + parametersYaml(options.parameters, arguments.method);
  auto runner = makeRunner(std::move(sequence).value(), options);
  if (!runner.ok()) return reportError(runner.error());
  return driveAndReport(*runner.value(), arguments, config);
}

}  // namespace

void addRunCommand(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("run", "Run a sequence and write the results");
  command->footer(kFooter);
  command->add_option("SEQUENCE", arguments->sequence, "Sequence to run")->required();
  command->add_option("--out", arguments->out, "Folder of the results, made if absent")
      ->required()
      ->type_name("DIR");
  command->add_option("--method", arguments->method, "Odometry method")
      ->check(CLI::IsMember({"svo"}))
      ->capture_default_str();
  command->add_flag("--sync", arguments->sync,
                    "Without threads: slower, the same result every time");
  command->add_option("--config", arguments->config, "YAML file with parameters")
      ->type_name("FILE");
  command->add_option("--set", arguments->settings, "One parameter as key=value; repeatable")
      ->allow_extra_args(false)
      ->type_name("KEY=VALUE");
  command->add_option("--start", arguments->start, "First frame, from 0")
      ->check(CLI::Range(0, 1000000000))
      ->capture_default_str();
  command->add_option("--max-frames", arguments->max_frames, "Stop after so many frames")
      ->check(CLI::Range(1, 1000000000));
  command->callback([arguments, &action] { action = [arguments] { return runRun(*arguments); }; });
}

}  // namespace svoscope
