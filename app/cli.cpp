// SPDX-License-Identifier: MIT
#include "app/cli.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "app/command.h"

namespace svoscope {

namespace {

constexpr const char* kFooter =
    "A sequence is 'synthetic:PRESET' (built in), a folder (TUM RGB-D, EuRoC/ASL, KITTI odometry,\n"
    "TUM-mono, images with a calibration) or a video with its calibration beside it.\n"
    "\n"
    "Examples:\n"
    "  svoscope synthetic:room                      watch the built-in room\n"
    "  svoscope run SEQUENCE --out results          trajectory, metrics, map\n"
    "  svoscope run SEQUENCE --record --out results the same, and all that the inspector shows\n"
    "  svoscope results/run.svoscope                look at the recording\n"
    "  svoscope eval groundtruth.txt results/trajectory.txt\n"
    "  svoscope bench bench.yaml --out bench        methods on many sequences, with report\n"
    "\n"
    "Exit codes: 0 done, 1 internal error, 2 usage, 3 input, 4 output not writable,\n"
    "5 never initialised, 130 interrupted.";

bool isCommand(const CLI::App& app, const std::string& word) {
  const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
  return std::any_of(commands.begin(), commands.end(),
                     [&](const CLI::App* command) { return command->check_name(word); });
}

/// A mistyped command must not be taken for a sequence that does not exist.
bool looksLikeCommand(const std::string& word) {
  std::error_code ec;
  return word.find_first_of("/:.-") == std::string::npos && !std::filesystem::exists(word, ec);
}

std::string commandNames(const CLI::App& app) {
  std::string names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    names += (names.empty() ? "" : ", ") + command->get_name();
  }
  return names;
}

int reportParseError(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
    return app.exit(error);  // --help and --version
  }
  std::string command = "svoscope";
  for (const CLI::App* used : app.get_subcommands()) command += " " + used->get_name();
  return reportError(usageError(error.what(), "", "see " + command + " --help"));
}

}  // namespace

int reportError(const Error& error) {
  std::fprintf(stderr, "svoscope: error: %s\n", error.message().c_str());
  return error.exitCode();
}

void reportWarning(const std::string& text) {
  std::fprintf(stderr, "svoscope: warning: %s\n", text.c_str());
}

int runCommandLine(std::vector<std::string> arguments) {
  CLI::App app("svoscope - an oscilloscope for semi-direct visual odometry", "svoscope");
  app.footer(kFooter);
  app.set_version_flag("--version", "svoscope " SVOSCOPE_VERSION);
  app.require_subcommand(1);
  app.get_formatter()->column_width(34);
  app.get_formatter()->label("REQUIRED", "(required)");
  app.get_formatter()->label("TEXT", "");
  Action action;
  addViewCommand(app, action);
  addRunCommand(app, action);
  addShotCommand(app, action);
  addEvalCommand(app, action);
  addConvertCommand(app, action);
  addCameraCommand(app, action);
  addBenchCommand(app, action);
  addSynthCommand(app, action);
  addLabCommand(app, action);
  addStressCommand(app, action);

  static const std::vector<std::string> kOwnOptions = {"-h", "--help", "--version"};
  if (arguments.empty()) {
    std::fputs(app.help().c_str(), stderr);
    return reportError(usageError("no sequence given", "", "try: svoscope synthetic:room"));
  }
  const std::string& first = arguments.front();
  const bool own = std::find(kOwnOptions.begin(), kOwnOptions.end(), first) != kOwnOptions.end();
  if (!own && !isCommand(app, first)) {
    if (looksLikeCommand(first)) {
      return reportError(usageError(fmt::format("'{}' is neither a command nor a sequence", first),
                                    "", "commands: " + commandNames(app)));
    }
    arguments.insert(arguments.begin(), "view");
  }
  try {
    std::reverse(arguments.begin(), arguments.end());  // as CLI11 expects
    app.parse(arguments);
  } catch (const CLI::ParseError& error) {
    return reportParseError(app, error);
  }
  return action();
}

}  // namespace svoscope
