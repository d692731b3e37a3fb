// SPDX-License-Identifier: MIT
// What every command of the program provides: it adds itself to the command line and leaves behind
// the action to run once all arguments are parsed.
#pragma once

#include <functional>
#include <string>

#include "engine/base/result.h"

namespace CLI {
class App;
}

namespace svoscope {

constexpr int kExitDone = 0;
constexpr int kExitNeverInitialised = 5;
constexpr int kExitInterrupted = 130;

/// Runs a command; returns the exit code.
using Action = std::function<int()>;

void addViewCommand(CLI::App& app, Action& action);
void addRunCommand(CLI::App& app, Action& action);
void addShotCommand(CLI::App& app, Action& action);
void addEvalCommand(CLI::App& app, Action& action);
void addConvertCommand(CLI::App& app, Action& action);
void addCameraCommand(CLI::App& app, Action& action);
void addBenchCommand(CLI::App& app, Action& action);
void addSynthCommand(CLI::App& app, Action& action);
void addLabCommand(CLI::App& app, Action& action);
void addStressCommand(CLI::App& app, Action& action);

/// Prints "svoscope: error: ..." to stderr; returns the exit code of the error.
int reportError(const Error& error);
/// Prints "svoscope: warning: ..." to stderr.
void reportWarning(const std::string& text);

}  // namespace svoscope
