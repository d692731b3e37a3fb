// SPDX-License-Identifier: MIT
// What both runners do alike: how a frame is published and ended, and which commands concern the
// engine. No threads: the caller owns the engine.
#pragma once

#include "engine/runner/engine.h"
#include "engine/runner/playback.h"
#include "engine/runner/run_log.h"

namespace svoscope {

/// Engine, playback and log of one run.
struct RunParts {
  Engine& engine;
  Playback& playback;
  RunLog& log;
  bool publish = true;  ///< a snapshot of every frame; else only where the run pauses or ends
};

/// Takes a command: playback, reset, pause and parameters. A parameter that cannot be set becomes a
/// warning event.
void applyCommand(const RunParts& run, const Command& command);

/// Ends a frame that went through engine and mapping: pauses if it was waited for, publishes
/// snapshot, row and events, and says so if it was the last.
void publishFrame(const RunParts& run);

/// Frames per second, smoothed over about ten frames.
class FrameRate {
 public:
  void add(double ms) { frame_ms_ = frame_ms_ > 0 ? 0.9 * frame_ms_ + 0.1 * ms : ms; }
  double fps() const { return frame_ms_ > 0 ? 1000.0 / frame_ms_ : 0; }

 private:
  double frame_ms_ = 0;
};

}  // namespace svoscope
