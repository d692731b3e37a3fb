// SPDX-License-Identifier: MIT
// svoscope run: a sequence from the first to the last frame, results into a folder.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/command.h"
#include "app/depth_study_run.h"
#include "app/drive.h"
#include "app/interrupt.h"
#include "app/method_table.h"
#include "app/progress.h"
#include "app/run_settings.h"

namespace svoscope {

namespace {

constexpr const char* kFooter =
    "Writes trajectory.txt, keyframes.txt, frames.csv, map.ply, metrics.json and config.yaml into\n"
    "DIR (docs/commands.md). Ctrl-C writes what is done and exits with 130.\n"
    "\n"
    "Examples:\n"
    "  svoscope run synthetic:room --out results\n"
    "  svoscope run SEQUENCE --method svo --sync --out results\n"
    "  svoscope run synthetic:room --depth-study --poses groundtruth --out study\n"
    "  svoscope run SEQUENCE --config mine.yaml --set detect.cell_px=25 --out results";

struct Arguments {
  RunSettings run;
  std::string out;
  bool sync = false;
  bool depth_study = false;
  std::string poses = "estimate";  ///< of the depth study
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

/// `report`: print the figures. `metrics` is filled once there are any.
int driveAndReport(Runner& runner, const Arguments& arguments, const std::string& config_yaml, bool report,
                   RunMetrics& result) {
  RunWriter writer;
  const Status begun = writer.begin(arguments.out, runner.info(), config_yaml);
  if (!begun.ok()) return reportError(begun.error());

  const InterruptGuard guard;
  DriveOptions options;
  options.first_frame = arguments.run.start;
  options.stop = &guard.flag();
  int last_frame = runner.info().frames;
  if (arguments.run.max_frames > 0) {
    last_frame = std::min(last_frame, arguments.run.start + arguments.run.max_frames);
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
  result = metrics.value();
  if (report) {
    fmt::print("{} on {}\n{}files       {}\n", runner.info().method, runner.info().sequence,
               metricsText(metrics.value()), writer.folder().string());
  }
  const int code = exitCodeOf(outcome, metrics.value());
  const bool poses_known = arguments.poses == "groundtruth" || code == kExitDone;
  if (!arguments.depth_study || outcome.interrupted || !poses_known) return code;
  const int study = runDepthStudyCommand(arguments.run, arguments.poses, arguments.out, writer.records());
  return study == kExitDone ? code : study;
}

int runOne(const Arguments& arguments, bool report, RunMetrics& metrics) {
  RunnerOptions options;
  options.threaded = !arguments.sync;
  options.publish_snapshots = false;  // nobody looks at them
  const Result<Parameters> parameters = arguments.run.parameters();
  if (!parameters.ok()) return reportError(parameters.error());
  const std::string config =
      "# svoscope " SVOSCOPE_VERSION "\n" + parametersYaml(parameters.value(), arguments.run.method);
  auto runner = arguments.run.open(options);
  if (!runner.ok()) return reportError(runner.error());
  return driveAndReport(*runner.value(), arguments, config, report, metrics);
}

/// Each method into a folder of its own, and one table of all. What went wrong first decides the exit
/// code; that a method never initialised only if it was so with all.
int runAll(const Arguments& arguments) {
  std::vector<RunMetrics> rows;
  int code = kExitDone, started = 0;
  for (const std::string& method : arguments.run.methods) {
    Arguments one = arguments;
    one.run = arguments.run.with(method);
    one.out = (std::filesystem::path(arguments.out) / method).string();
    RunMetrics metrics;
    const int ended = runOne(one, false, metrics);
    if (metrics.method.empty()) return ended;  // not even begun
    rows.push_back(metrics);
    started += ended == kExitDone;
    if (ended != kExitDone && ended != kExitNeverInitialised && code == kExitDone) code = ended;
    if (ended == kExitInterrupted) break;
  }
  fmt::print("{}\n{}files       {}\n", arguments.run.sequence, methodTable(rows), arguments.out);
  return code == kExitDone && started == 0 ? kExitNeverInitialised : code;
}

int runRun(const Arguments& arguments) {
  if (arguments.run.methods.size() > 1) return runAll(arguments);
  RunMetrics metrics;
  return runOne(arguments, true, metrics);
}

}  // namespace

void addRunCommand(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("run", "Run a sequence and write the results");
  command->footer(kFooter);
  arguments->run.addTo(*command);
  command->add_option("--out", arguments->out, "Folder of the results, made if absent")
      ->required()
      ->type_name("DIR");
  command->add_flag("--sync", arguments->sync,
                    "Without threads: slower, the same result every time");
  command->add_flag("--depth-study", arguments->depth_study,
                    "Also hold both depth filters against true depth");
  command->add_option("--poses", arguments->poses, "Camera poses of the depth study")
      ->check(CLI::IsMember({"estimate", "groundtruth"}))
      ->capture_default_str();
  command->callback([arguments, &action] { action = [arguments] { return runRun(*arguments); }; });
}

}  // namespace svoscope
