// SPDX-License-Identifier: MIT
#include "app/run_settings.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

namespace svoscope {

void RunSettings::addTo(CLI::App& command, bool required) {
  command.add_option("SEQUENCE", sequence, "Sequence: folder, video or synthetic:PRESET")->required(required);
  command.add_option("--method", method, "Odometry method")
      ->check(CLI::IsMember({"svo", "pl-svo", "it-svo"}))
      ->capture_default_str();
  command.add_option("--config", config, "YAML file with parameters")->type_name("FILE");
  command.add_option("--set", assignments, "One parameter as key=value; repeatable")
      ->allow_extra_args(false)
      ->type_name("KEY=VALUE");
  command.add_option("--start", start, "First frame, from 0")
      ->check(CLI::Range(0, 1000000000))
      ->capture_default_str();
  command.add_option("--max-frames", max_frames, "Stop after so many frames")
      ->check(CLI::Range(1, 1000000000));
}

Result<Parameters> RunSettings::parameters() const {
  Parameters parameters;
  if (!config.empty()) {
    const Status loaded = loadParameters(parameters, config);
    if (!loaded.ok()) return loaded.error();
  }
  for (const std::string& assignment : assignments) {
    const auto equals = assignment.find('=');
    if (equals == std::string::npos || equals == 0)
      return usageError("'" + assignment + "' is not key=value", "--set", "as in --set reproject.cell_px=30");
    const Status set = setParameter(parameters, assignment.substr(0, equals), assignment.substr(equals + 1));
    if (!set.ok()) return set.error();
  }
  return parameters;
}

Result<std::unique_ptr<Runner>> RunSettings::open(RunnerOptions options) const {
  Result<Parameters> chosen = parameters();
  if (!chosen.ok()) return chosen.error();
  options.parameters = chosen.value();
  options.method = method;
  options.start = start;
  options.max_frames = max_frames;
  auto opened = openSequence(sequence);
  if (!opened.ok()) return opened.error();
  return makeRunner(std::move(opened).value(), options);
}

}  // namespace svoscope
