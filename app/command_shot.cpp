// SPDX-License-Identifier: MIT
// svoscope shot: drives the inspector without a display and writes pictures.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <optional>

#include "app/command.h"
#include "app/open_runs.h"
#include "app/output_folder.h"
#include "app/run_settings.h"
#include "ui/application.h"
#include "ui/harness/script.h"

namespace svoscope {

namespace {

struct Arguments {
  RunSettings run;
  CompareSettings compare;
  std::string script, out;
  std::string size = "1600x1000";
  double scale = 1;
};

/// The sequence of the command line, or the one that the script opens.
Result<std::string> sequenceOf(const Arguments& a, const ui::Script& script) {
  const std::optional<std::string> named = script.sequence();
  if (a.run.sequence.empty() && !named)
    return usageError("no sequence given", "",
                      "name one on the command line or begin the script with open SEQUENCE");
  if (!a.run.sequence.empty() && named && *named != a.run.sequence) {
    return usageError("the script opens " + *named + ", the command line names " + a.run.sequence,
                      a.script, "leave one of them out");
  }
  return named ? *named : a.run.sequence;
}

int runShot(const Arguments& a) {
  const Result<ui::Script> script = ui::readScript(a.script);  // once: it may be a pipe
  if (!script.ok()) return reportError(script.error());
  const Result<std::string> sequence = sequenceOf(a, script.value());
  if (!sequence.ok()) return reportError(sequence.error());
  const Status folder = prepareOutputFolder(a.out);
  if (!folder.ok()) return reportError(folder.error());
  RunSettings run = a.run;
  run.sequence = sequence.value();
  // Scripts name frames and seeds: only the synchronous engine gives the same ones every time.
  RunnerOptions options;
  options.threaded = false;
  auto runner = openRuns(run, a.compare, options);
  if (!runner.ok()) return reportError(runner.error());
  ui::InspectorOptions inspector;
  inspector.runner = std::move(runner).value();
  inspector.surface = ui::SurfaceKind::osmesa;
  std::sscanf(a.size.c_str(), "%dx%d", &inspector.width, &inspector.height);
  inspector.scale = static_cast<float>(a.scale);
  inspector.script = script.value();
  inspector.out = a.out;
  return ui::runInspector(inspector);
}

/// "WxH" with sides a surface can have.
std::string checkSize(const std::string& text) {
  int width = 0, height = 0;
  char rest = 0;
  const int read = std::sscanf(text.c_str(), "%5dx%5d%c", &width, &height, &rest);
  const bool good = read == 2 && width >= 64 && height >= 64 && width <= 16384 && height <= 16384;
  return good ? "" : "'" + text + "' is not a size such as 1600x1000";
}

}  // namespace

void addShotCommand(CLI::App& app, Action& action) {
  const auto a = std::make_shared<Arguments>();
  CLI::App* command =
      app.add_subcommand("shot", "Drive the inspector by a script without a display, write PNGs");
  command->footer(
      "Example:\n"
      "  svoscope shot synthetic:room --script tour.script --out pictures --size 1920x1080\n"
      "  svoscope shot synthetic:room --method all --script compare.script --out pictures\n"
      "\n"
      "SEQUENCE may be left out if the script begins with open SEQUENCE. The script language is\n"
      "described in docs/scripts.md.\n"
      "\n"
      "Exit codes: 0 the script ran to its end, 1 an expect or run-to was not met, 2 a command\n"
      "cannot be carried out, 3 the script or sequence cannot be read, 4 a picture cannot be "
      "written.");
  a->run.addTo(*command, false);
  a->compare.addTo(*command);
  command->add_option("--script", a->script, "Script of actions")->required()->type_name("FILE");
  command->add_option("--out", a->out, "Folder of the pictures")->required()->type_name("DIR");
  command->add_option("--size", a->size, "Size in pixels, WxH")
      ->check(CLI::Validator(checkSize, "WxH"))
      ->capture_default_str();
  command->add_option("--scale", a->scale, "Scale of text and widgets")
      ->check(CLI::Range(0.5, 4.0))
      ->capture_default_str();
  command->callback([a, &action] { action = [a] { return runShot(*a); }; });
}

}  // namespace svoscope
