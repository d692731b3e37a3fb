// SPDX-License-Identifier: MIT
// svoscope shot: drives the inspector without a display and writes pictures.
#include <CLI/CLI.hpp>
#include <memory>

#include "app/command.h"

namespace svoscope {

namespace {

struct Arguments {
  std::string sequence, script, out;
  std::string size = "1600x900";
  double scale = 1;
};

int runShot(const Arguments& arguments) {
  return reportError({ErrorKind::internal, "this build has no inspector", arguments.sequence,
                      "use: svoscope run SEQUENCE --out DIR"});
}

/// "WxH" with sides a surface can have.
std::string checkSize(const std::string& text) {
  int width = 0, height = 0;
  char rest = 0;
  const int read = std::sscanf(text.c_str(), "%5dx%5d%c", &width, &height, &rest);
  const bool good = read == 2 && width >= 64 && height >= 64 && width <= 16384 && height <= 16384;
  return good ? "" : "'" + text + "' is not a size such as 1600x900";
}

}  // namespace

void addShotCommand(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      app.add_subcommand("shot", "Drive the inspector by a script without a display, write PNGs");
  command->footer(
      "Example:\n"
      "  svoscope shot synthetic:room --script tour.script --out pictures --size 1920x1080");
  command->add_option("SEQUENCE", arguments->sequence, "Sequence to inspect")->required();
  command->add_option("--script", arguments->script, "Script of actions")->required();
  command->add_option("--out", arguments->out, "Folder of the pictures")->required();
  command->add_option("--size", arguments->size, "Size in pixels, WxH")
      ->check(CLI::Validator(checkSize, "WxH"))
      ->capture_default_str();
  command->add_option("--scale", arguments->scale, "Scale of text and widgets")
      ->check(CLI::Range(0.5, 4.0))
      ->capture_default_str();
  command->callback([arguments, &action] { action = [arguments] { return runShot(*arguments); }; });
}

}  // namespace svoscope
