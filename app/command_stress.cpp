// SPDX-License-Identifier: MIT
// svoscope stress: where does each method break?
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>

#include "app/command.h"
#include "app/interrupt.h"
#include "app/progress.h"
#include "app/run_settings.h"
#include "engine/io/stress_writer.h"
#include "engine/io/text_output.h"

namespace svoscope {

namespace {

constexpr const char* kFooter =
    "Runs the methods on rendered sequences made hard in a known way and writes stress.csv (one "
    "row\n"
    "per run) and stress.md (tables) into DIR (docs/robustness.md). One thread, the same result\n"
    "every time. Ctrl-C writes what is done and exits with 130.\n"
    "\n"
    "Examples:\n"
    "  svoscope stress --out stress\n"
    "  svoscope stress --stresses blackout,speed --methods it-svo --out stress\n"
    "  svoscope stress --list";

struct Arguments {
  RunSettings run;  ///< --config and --set only
  std::string out;
  std::vector<std::string> methods = StressOptions().methods;
  std::vector<std::string> names;  ///< empty: all
  StressSize size;
  bool list = false;
};

/// Usage error naming the stresses there are.
Result<std::vector<Stress>> chosenStresses(const Arguments& arguments) {
  std::vector<Stress> all = stressTable(arguments.size), chosen;
  if (arguments.names.empty()) return all;
  for (const std::string& name : arguments.names) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Stress& s) { return s.name == name; });
    if (found == all.end()) {
      std::string known;
      for (const Stress& s : all) known += (known.empty() ? "" : ", ") + s.name;
      return usageError("unknown stress '" + name + "'", "--stresses", "stresses are " + known);
    }
    chosen.push_back(*found);
  }
  return chosen;
}

int listStresses(const std::vector<Stress>& stresses) {
  for (const Stress& stress : stresses) {
    fmt::print("{}: {}\n", stress.name, stress.meaning);
    for (const StressLevel& level : stress.levels)
      fmt::print("  {:<6} {}\n", level.strength, level.sequence);
  }
  return kExitDone;
}

int runStress(const Arguments& arguments) {
  const auto stresses = chosenStresses(arguments);
  if (!stresses.ok()) return reportError(stresses.error());
  if (arguments.list) return listStresses(stresses.value());
  if (arguments.out.empty())
    return reportError(usageError("no folder given", "--out", "see svoscope stress --help"));
  const Result<Parameters> parameters = arguments.run.parameters();
  if (!parameters.ok()) return reportError(parameters.error());
  const std::filesystem::path folder = arguments.out;
  LineFile csv;
  Status status = makeFolder(folder);
  if (status.ok()) status = csv.open(folder / "stress.csv");
  if (status.ok()) status = csv.write(stressCsvHeader());
  if (!status.ok()) return reportError(status.error());

  const InterruptGuard guard;
  StressOptions options;
  options.methods = arguments.methods;
  options.parameters = parameters.value();
  options.stop = &guard.flag();
  options.finished = [&](const StressRow& row) { return csv.write(stressCsvRow(row)); };
  Result<std::vector<StressRow>> rows = std::vector<StressRow>();
  {
    Progress progress;
    options.progress = [&](const std::string& text) { progress.show(text); };
    rows = runStresses(stresses.value(), options);
  }
  if (!rows.ok()) return reportError(rows.error());
  status = writeWhole(folder / "stress.md", stressMarkdown(stresses.value(), rows.value()));
  if (!status.ok()) return reportError(status.error());
  fmt::print("{}files in {}\n", stressText(stresses.value(), rows.value()), arguments.out);
  if (!guard.flag()) return kExitDone;
  reportWarning("interrupted; what was done is written");
  return kExitInterrupted;
}

}  // namespace

void addStressCommand(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("stress", "Find out where each method breaks");
  command->footer(kFooter);
  command->add_option("--out", arguments->out, "Folder of the results, made if absent")
      ->type_name("DIR");
  command->add_option("--methods", arguments->methods, "Methods, separated by commas")
      ->delimiter(',')
      ->check(CLI::IsMember(methodIds()))
      ->type_name("LIST")
      ->capture_default_str();
  command->add_option("--stresses", arguments->names, "Stresses, separated by commas; default: all")
      ->delimiter(',')
      ->type_name("LIST");
  command->add_option("--frames", arguments->size.frames, "Frames of each sequence")
      ->check(CLI::Range(20, 100000))
      ->capture_default_str();
  command->add_option("--width", arguments->size.width, "Width of the images, px")
      ->check(CLI::Range(64, 4096))
      ->capture_default_str();
  command->add_option("--height", arguments->size.height, "Height of the images, px")
      ->check(CLI::Range(48, 4096))
      ->capture_default_str();
  command->add_option("--config", arguments->run.config, "YAML file with parameters")
      ->type_name("FILE");
  command->add_option("--set", arguments->run.assignments, "One parameter as key=value; repeatable")
      ->allow_extra_args(false)
      ->type_name("KEY=VALUE");
  command->add_flag("--list", arguments->list, "Only print the stresses and their sequences");
  command->callback(
      [arguments, &action] { action = [arguments] { return runStress(*arguments); }; });
}

}  // namespace svoscope
