// SPDX-License-Identifier: MIT
// svoscope lab: every rule of the depth filter on simulated seeds.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/command.h"
#include "engine/io/lab_writer.h"

namespace svoscope {

namespace {

struct Arguments {
  std::string out;
  LabOptions lab;
};

int runLabCommand(const Arguments& arguments) {
  const std::string wrong = arguments.lab.check();
  if (!wrong.empty()) return reportError(usageError("out of bounds", "", wrong));
  const LabResult result = runLab(arguments.lab);
  const Status written = writeLab(arguments.out, result);
  if (!written.ok()) return reportError(written.error());
  fmt::print("{} simulated seeds, {} updates\n{}files in {}\n", arguments.lab.seeds,
             arguments.lab.updates, labText(result), arguments.out);
  return kExitDone;
}

}  // namespace

void addLabCommand(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<Arguments>();
  LabOptions& lab = arguments->lab;
  CLI::App* command =
      app.add_subcommand("lab", "Compare the KL and JS depth filters on simulated seeds");
  command->footer(
      "Writes lab.csv, curves.csv and lab.png into DIR (docs/filters.md).\n\n"
      "Example:\n  svoscope lab --outliers 0.4 --out lab");
  command->add_option("--out", arguments->out, "Folder of the results, made if absent")
      ->required()
      ->type_name("DIR");
  const auto option = [&](const char* name, auto& value, const char* meaning) {
    command->add_option(name, value, meaning)->capture_default_str();
  };
  option("--seeds", lab.seeds, "Seeds");
  option("--updates", lab.updates, "Measurements of each seed");
  option("--outliers", lab.outliers, "Fraction of measurements that fall anywhere in the window");
  option("--hopeless", lab.hopeless, "Fraction of seeds that never see a right measurement");
  option("--noise", lab.noise, "Noise of a right measurement, in tau");
  option("--search-sigmas", lab.search_sigmas, "Half width of the search window, in sigma");
  option("--step", lab.step_m, "Baseline gained per frame, m");
  option("--focal", lab.focal_px, "Focal length, px");
  option("--mean-depth", lab.mean_depth_m, "Mean depth, m");
  option("--min-depth", lab.min_depth_m, "Least depth, m");
  option("--seed", lab.random_seed, "Of the random numbers");
  command->callback(
      [arguments, &action] { action = [arguments] { return runLabCommand(*arguments); }; });
}

}  // namespace svoscope
