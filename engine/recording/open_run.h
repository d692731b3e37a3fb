// SPDX-License-Identifier: MIT
// One way to open whatever can be looked at: a sequence, which the engine then runs, or a
// recording.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "engine/base/result.h"
#include "engine/runner/make_runner.h"

namespace svoscope {

/// True for a file named *.svoscope and for any SQLite file.
bool looksLikeRecording(const std::filesystem::path& file);

/// `spec`: a sequence as openSequence() takes it, or a recording's file. A recording brings its own
/// method and parameters: `options` then has no effect.
Result<std::unique_ptr<Runner>> openRun(const std::string& spec, const RunnerOptions& options);

}  // namespace svoscope
