// SPDX-License-Identifier: MIT
// svoscope synth: a built-in sequence as files, with exact ground truth and depth.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/command.h"
#include "app/interrupt.h"
#include "app/progress.h"
#include "engine/dataset/sequence.h"
#include "engine/dataset/write_tum.h"
#include "engine/io/text_output.h"

namespace svoscope {

namespace {

struct Arguments {
  std::string preset, out;
};

int runSynth(const Arguments& arguments) {
  const bool prefixed = arguments.preset.rfind("synthetic:", 0) == 0;
  const auto sequence = openSequence(prefixed ? arguments.preset : "synthetic:" + arguments.preset);
  if (!sequence.ok()) return reportError(sequence.error());
  const Status folder = makeFolder(arguments.out);
  if (!folder.ok()) return reportError(folder.error());
  const InterruptGuard guard;
  Status written = Done{};
  {
    Progress progress;
    written = writeTumSequence(*sequence.value(), arguments.out, [&](int done, int total) {
      progress.show(fmt::format("frame {}/{}", done, total));
      return !guard.flag();
    });
  }
  if (!written.ok()) return reportError(written.error());
  if (guard.flag()) {
    reportWarning("interrupted; the frames written so far are listed");
    return kExitInterrupted;
  }
  fmt::print("{} frames of {} in {}\n", sequence.value()->size(), sequence.value()->name(),
             arguments.out);
  return kExitDone;
}

}  // namespace

void addSynthCommand(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      app.add_subcommand("synth", "Write a synthetic sequence in TUM layout, with depth and truth");
  command->footer("Example:\n  svoscope synth room --out room\n  svoscope run room --out results");
  command->add_option("PRESET", arguments->preset, "Name of the scene: room, desk, ...")
      ->required();
  command->add_option("--out", arguments->out, "Folder of the sequence, made if absent")
      ->required();
  command->callback(
      [arguments, &action] { action = [arguments] { return runSynth(*arguments); }; });
}

}  // namespace svoscope
