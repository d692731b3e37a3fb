// SPDX-License-Identifier: MIT
#include "app/run_settings.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "engine/recording/open_run.h"

namespace svoscope {

void RunSettings::addTo(CLI::App& command, bool required, const char* what) {
  command.add_option("SEQUENCE", sequence, what)->required(required);
  CLI::Option* chosen_method = command.add_option("--method", method, "Odometry method")
      ->check(CLI::IsMember({"svo", "pl-svo", "it-svo"}))
      ->capture_default_str();
  CLI::Option* chosen_config = command.add_option("--config", config, "YAML file with parameters")->type_name("FILE");
  CLI::Option* chosen_set = command.add_option("--set", assignments, "One parameter as key=value; repeatable")
      ->allow_extra_args(false)
      ->type_name("KEY=VALUE");
  CLI::Option* chosen_start = command.add_option("--start", start, "First frame, from 0")
      ->check(CLI::Range(0, 1000000000))
      ->capture_default_str();
  CLI::Option* chosen_end = command.add_option("--max-frames", max_frames, "Stop after so many frames")
      ->check(CLI::Range(1, 1000000000));
  of_engine_ = {chosen_method, chosen_config, chosen_set, chosen_start, chosen_end};
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
  if (looksLikeRecording(sequence)) {
    for (const CLI::Option* option : of_engine_) {
      if (option->count() > 0)
        return usageError("a recording brings its own method and parameters", option->get_name(), "leave the option out");
    }
  }
  return openRun(sequence, options);
}

}  // namespace svoscope
