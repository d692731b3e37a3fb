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
#include "engine/io/metrics_writer.h"
#include "engine/recording/open_run.h"
#include "engine/recording/recorder.h"

namespace svoscope {

namespace {

constexpr const char* kFooter =
    "Writes trajectory.txt, keyframes.txt, frames.csv, map.ply, metrics.json and config.yaml into\n"
    "DIR (docs/commands.md); with --record also run.svoscope (docs/recording.md). Ctrl-C writes "
    "what is\n"
    "done and exits with 130.\n"
    "\n"
    "Examples:\n"
    "  svoscope run synthetic:room --out results\n"
    "  svoscope run SEQUENCE --method svo --sync --out results\n"
    "  svoscope run SEQUENCE --record --out results && svoscope results/run.svoscope\n"
    "  svoscope run synthetic:room --depth-study --poses groundtruth --out study\n"
    "  svoscope run SEQUENCE --config mine.yaml --set detect.cell_px=25 --out results";

struct Arguments {
  RunSettings run;
  std::string out;
  bool sync = false;
  bool depth_study = false;
  bool record = false;
  int quality = RecordingOptions().jpeg_quality;
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

/// `report`: print the figures. `result` is filled once there are any.
int driveAndReport(Runner& runner, RunWriter& writer, const Arguments& arguments, bool report,
                   RunMetrics& result) {
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
  const int study =
      runDepthStudyCommand(arguments.run, arguments.poses, arguments.out, writer.records());
  return study == kExitDone ? code : study;
}

/// The recording's own outcome counts only if the run itself went well.
int closeRecording(Recorder& recorder, int code) {
  const Status closed = recorder.close();
  if (closed.ok()) return code;
  const int failed = reportError(closed.error());
  return code == kExitDone || code == kExitNeverInitialised ? failed : code;
}

int runOne(const Arguments& arguments, bool report, RunMetrics& metrics) {
  RunnerOptions options;
  options.threaded = !arguments.sync;
  options.publish_snapshots = arguments.record;  // else nobody looks at them
  options.place_seeds = false;
  options.history_budget = 64u << 20;  // the recorder has its own queue
  const Result<Parameters> parameters = arguments.run.parameters();
  if (!parameters.ok()) return reportError(parameters.error());
  const std::string config = "# svoscope " SVOSCOPE_VERSION "\n" +
                             parametersYaml(parameters.value(), arguments.run.method);
  const auto recorder = std::make_shared<Recorder>();
  if (arguments.record) options.observer = recorder;
  if (arguments.depth_study) {
    const Status possible = checkDepthStudy(arguments.run);  // now, not after the run
    if (!possible.ok()) return reportError(possible.error());
  }
  auto runner = arguments.run.open(options);
  if (!runner.ok()) return reportError(runner.error());
  RunWriter writer;
  Status begun = writer.begin(arguments.out, runner.value()->info(), config);
  if (begun.ok() && arguments.record)
    begun =
        recorder->start(writer.folder() / kRecordingName, {SVOSCOPE_VERSION, arguments.quality});
  if (!begun.ok()) return reportError(begun.error());
  const int code = driveAndReport(*runner.value(), writer, arguments, report, metrics);
  return closeRecording(*recorder, code);
}

/// Each method into a folder of its own, and one table of all. What went wrong first decides the
/// exit code; that a method never initialised only if it was so with all.
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
  if (looksLikeRecording(arguments.run.sequence))
    return reportError(usageError("is a recording, run needs a sequence", arguments.run.sequence,
                                  "open it with svoscope view"));
  if (arguments.run.methods.size() > 1) return runAll(arguments);
  RunMetrics metrics;
  return runOne(arguments, true, metrics);
}

}  // namespace

void addRunCommand(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("run", "Run a sequence and write the results");
  command->footer(kFooter);
  arguments->run.addTo(*command, true, "Sequence: folder, video or synthetic:PRESET");
  command->add_option("--out", arguments->out, "Folder of the results, made if absent")
      ->required()
      ->type_name("DIR");
  command->add_flag("--sync", arguments->sync,
                    "Without threads: slower, the same result every time");
  CLI::Option* record = command->add_flag("--record", arguments->record,
                                          "Also record everything for the inspector: run.svoscope");
  command->add_option("--record-quality", arguments->quality, "JPEG quality of the recorded images")
      ->needs(record)
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  CLI::Option* study = command->add_flag("--depth-study", arguments->depth_study,
                                         "Also hold both depth filters against true depth");
  command->add_option("--poses", arguments->poses, "Camera poses of the depth study")
      ->needs(study)
      ->check(CLI::IsMember({"estimate", "groundtruth"}))
      ->capture_default_str();
  command->callback([arguments, &action] { action = [arguments] { return runRun(*arguments); }; });
}

}  // namespace svoscope
