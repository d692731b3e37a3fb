// SPDX-License-Identifier: MIT
// The language that drives the UI without hands: one command a line, for tests, for the pictures
// of the documentation and for users. This file is text -> commands; executor.h runs them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace svoscope::ui {

struct ScriptCommand {
  int line = 0;
  std::string name;
  std::vector<std::string> arguments;  ///< words; quotes removed
  std::string rest;                    ///< everything after the name, as written
};

struct Script {
  std::string source;  ///< file name, for messages
  std::vector<ScriptCommand> commands;

  /// The sequence named by a leading `open`; the program opens it if the command line names none.
  std::optional<std::string> sequence() const;
};

/// Checks names and numbers of arguments; an error names the line and the known commands.
Result<Script> parseScript(const std::string& text, const std::string& source);
/// Reads the file once, so that it may be a pipe.
Result<Script> readScript(const std::filesystem::path& file);

/// "step [N]" and so on, one line each with what it does, for `--help` and messages.
std::string scriptHelp();

/// An error at a command: "demo.script:12: ...".
Error scriptError(const Script& script, const ScriptCommand& command, std::string what,
                  std::string remedy = "");

}  // namespace svoscope::ui
