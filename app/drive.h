// SPDX-License-Identifier: MIT
// Plays a runner to its end and hands every frame to the writer.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "engine/io/run_writer.h"
#include "engine/runner/runner.h"

namespace svoscope {

struct DriveOptions {
  int first_frame = 0;  ///< sequence index at which the runner starts
  /// Set from outside (signal handler) to end the run early.
  const std::atomic<bool>* stop = nullptr;
  /// Called after every written frame.
  std::function<void(const FrameRecord&, const RunnerStatus&)> progress;
};

struct DriveOutcome {
  int frames = 0;                     ///< went through the engine, unreadable ones included
  bool interrupted = false;           ///< by `stop`
  std::vector<std::string> warnings;  ///< texts of the engine's warning events
  std::vector<std::string> errors;    ///< texts of its error events
};

/// Sends "play" and returns when the sequence is through, `stop` is set or the engine gave up (see
/// errors). Everything processed is in the writer then. Output error if the writer fails.
Result<DriveOutcome> drive(Runner& runner, RunWriter& writer, const DriveOptions& options);

}  // namespace svoscope
