// SPDX-License-Identifier: MIT
// svoscope view: the inspector, in a window or rendered to files.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/command.h"
#include "app/open_runs.h"
#include "app/output_folder.h"
#include "app/run_settings.h"
#include "app/tour.h"
#include "engine/runner/lockstep_runner.h"
#include "ui/application.h"

namespace svoscope {

namespace {

struct Arguments {
  RunSettings run;
  CompareSettings compare;
  bool headless = false, paused = false, sync = false;
  std::string out;
  double scale = 1;
  int close_after = 0;
};

/// In a window the sequence plays at its own rate; rendered to files it is stepped by the tour.
int runView(const Arguments& a) {
  const std::string out = !a.out.empty() ? a.out : a.headless ? "svoscope-screens" : ".";
  if (a.headless) {
    const Status folder = prepareOutputFolder(out);
    if (!folder.ok()) return reportError(folder.error());
  }
  RunnerOptions options;
  options.threaded = !a.headless && !a.sync;
  auto runner = openRuns(a.run, a.compare, options);
  if (!runner.ok()) return reportError(runner.error());
  ui::InspectorOptions inspector;
  inspector.scale = static_cast<float>(a.scale);
  inspector.out = out;
  inspector.exit_after_frames = a.headless ? 0 : a.close_after;
  if (a.headless) {
    inspector.surface = ui::SurfaceKind::osmesa;
    const bool several = dynamic_cast<const LockstepRunner*>(runner.value().get()) != nullptr;
    const auto tour = writeTour(out, runner.value()->info(), several);
    if (!tour.ok()) return reportError(tour.error());
    const auto script = ui::readScript(tour.value());
    if (!script.ok()) return reportError(script.error());
    inspector.script = script.value();
  } else {
    const RunInfo& info = runner.value()->info();
    runner.value()->send(
        {Command::Kind::set_speed, -1, "", std::to_string(info.rate_hz > 0 ? info.rate_hz : 30.0)});
    if (runner.value()->status().recorded && !a.paused) {
      runner.value()->send(
          {Command::Kind::run_to_frame, info.frames, "", ""});  // all of it at once
    } else {
      runner.value()->send({a.paused ? Command::Kind::step : Command::Kind::play, -1, "", ""});
    }
  }
  inspector.runner = std::move(runner).value();
  const int code = ui::runInspector(inspector);
  if (a.headless && code == kExitDone) std::printf("screens are in %s\n", inspector.out.c_str());
  return code;
}

}  // namespace

void addViewCommand(CLI::App& app, Action& action) {
  const auto a = std::make_shared<Arguments>();
  CLI::App* command =
      app.add_subcommand("view", "Open the inspector (the default when a sequence is given)");
  command->footer(
      "Examples:\n"
      "  svoscope synthetic:room\n"
      "  svoscope view SEQUENCE --paused\n"
      "  svoscope view SEQUENCE --method all --trajectory orb.txt=ORB-SLAM2\n"
      "  svoscope view results/run.svoscope\n"
      "  svoscope view SEQUENCE --headless --out screens");
  a->run.addTo(*command);
  a->compare.addTo(*command);
  command->add_flag("--headless", a->headless, "No window: render the main screens to PNG files");
  command->add_option("--out", a->out, "Folder of screenshots [., headless: svoscope-screens]")
      ->type_name("DIR");
  command->add_flag("--paused", a->paused, "Show the first frame and wait");
  command
      ->add_option("--close-after", a->close_after, "Close the window after so many drawn frames")
      ->check(CLI::Range(1, 1000000000));
  command->add_flag("--sync", a->sync, "Engine without threads: the same result every time");
  command->add_option("--scale", a->scale, "Scale of text and widgets")
      ->check(CLI::Range(0.5, 4.0))
      ->capture_default_str();
  command->callback([a, &action] { action = [a] { return runView(*a); }; });
}

}  // namespace svoscope
