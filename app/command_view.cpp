// SPDX-License-Identifier: MIT
// svoscope view: the inspector.
#include <CLI/CLI.hpp>
#include <memory>

#include "app/command.h"

namespace svoscope {

namespace {

struct Arguments {
  std::string sequence;
  std::string method = "it-svo";
  bool headless = false;
};

int runView(const Arguments& arguments) {
  return reportError({ErrorKind::internal, "this build has no inspector", arguments.sequence,
                      "use: svoscope run SEQUENCE --out DIR"});
}

}  // namespace

void addViewCommand(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      app.add_subcommand("view", "Open the inspector (the default when a sequence is given)");
  command->footer("Examples:\n  svoscope synthetic:room\n  svoscope view SEQUENCE --method svo");
  command->add_option("SEQUENCE", arguments->sequence, "Sequence to inspect")->required();
  command->add_option("--method", arguments->method, "Odometry method")
      ->check(CLI::IsMember({"svo", "pl-svo", "it-svo"}))
      ->capture_default_str();
  command->add_flag("--headless", arguments->headless, "No window: render to pictures");
  command->callback([arguments, &action] { action = [arguments] { return runView(*arguments); }; });
}

}  // namespace svoscope
