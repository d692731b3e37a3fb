// SPDX-License-Identifier: MIT
// The command line: finds the command and runs it.
#pragma once

#include <string>
#include <vector>

namespace svoscope {

/// Runs the program with its arguments (without the program's name); returns the exit code
/// (docs/commands.md). A sequence without a command opens the inspector.
int runCommandLine(std::vector<std::string> arguments);

}  // namespace svoscope
