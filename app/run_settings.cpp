// SPDX-License-Identifier: MIT
#include "app/run_settings.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/command.h"
#include "engine/recording/open_run.h"

namespace svoscope {

RunSettings RunSettings::with(const std::string& other_method) const {
  RunSettings other = *this;
  other.method = other_method;
  other.methods = {other_method};
  return other;
}

void RunSettings::addTo(CLI::App& command, bool required, const char* what) {
  command.add_option("SEQUENCE", sequence, what)->required(required);
  const auto choose = [this](const std::vector<std::string>& chosen) {
    methods.clear();
    for (const std::string& name : chosen) {
      for (const std::string& one : name == "all" ? methodIds() : std::vector<std::string>{name}) {
        if (std::find(methods.begin(), methods.end(), one) == methods.end()) methods.push_back(one);
      }
    }
    method = methods.front();
  };
  std::vector<std::string> choices = methodIds();
  choices.push_back("all");
  CLI::Option* chosen_method = command
                                   .add_option_function<std::vector<std::string>>(
                                       "--method", choose, "Odometry method; repeatable")
                                   ->check(CLI::IsMember(choices))
                                   ->allow_extra_args(false)
                                   ->type_name("METHOD")
                                   ->default_str(method);
  CLI::Option* chosen_config =
      command.add_option("--config", config, "YAML file with parameters")->type_name("FILE");
  CLI::Option* chosen_set =
      command.add_option("--set", assignments, "One parameter as key=value; repeatable")
          ->allow_extra_args(false)
          ->type_name("KEY=VALUE");
  CLI::Option* chosen_start = command.add_option("--start", start, "First frame, from 0")
                                  ->check(CLI::Range(0, 1000000000))
                                  ->capture_default_str();
  CLI::Option* chosen_end =
      command.add_option("--max-frames", max_frames, "Stop after so many frames")
          ->check(CLI::Range(1, 1000000000));
  CLI::Option* chosen_camera =
      command
          .add_option("--camera", input.camera,
                      "Calibration in place of the sequence's own, of any known tool")
          ->type_name("FILE");
  CLI::Option* chosen_rate =
      command.add_option("--rate", input.rate_hz, "Frame rate of images without times")
          ->check(CLI::Range(1e-3, 1e5))
          ->type_name("HZ");
  of_engine_ = {chosen_method, chosen_config, chosen_set, chosen_start,
                chosen_end,    chosen_camera, chosen_rate};
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
      return usageError("'" + assignment + "' is not key=value", "--set",
                        "as in --set reproject.cell_px=30");
    const Status set =
        setParameter(parameters, assignment.substr(0, equals), assignment.substr(equals + 1));
    if (!set.ok()) return set.error();
  }
  return parameters;
}

Result<std::unique_ptr<Sequence>> RunSettings::openInput() const {
  auto opened = openSequence(sequence, input);
  if (opened.ok()) {
    for (const std::string& text : opened.value()->notes()) reportWarning(text);
  }
  return opened;
}

Result<std::unique_ptr<Runner>> RunSettings::open(RunnerOptions options) const {
  const Result<Parameters> checked = parameters();  // before a large sequence is opened
  if (!checked.ok()) return checked.error();
  if (looksLikeRecording(sequence)) {
    for (const CLI::Option* option : of_engine_) {
      if (option->count() > 0)
        return usageError("a recording brings its own method and parameters", option->get_name(),
                          "leave the option out");
    }
    return openRun(sequence, options);
  }
  auto opened = openInput();
  if (!opened.ok()) return opened.error();
  return open(std::move(options), std::move(opened).value());
}

Result<std::unique_ptr<Runner>> RunSettings::open(RunnerOptions options,
                                                  std::unique_ptr<Sequence> opened) const {
  Result<Parameters> chosen = parameters();
  if (!chosen.ok()) return chosen.error();
  options.parameters = chosen.value();
  options.method = method;
  options.start = start;
  options.max_frames = max_frames;
  return makeRunner(std::move(opened), options);
}

}  // namespace svoscope
