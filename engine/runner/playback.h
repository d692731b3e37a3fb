// SPDX-License-Identifier: MIT
// Play, pause and "run to": which frame may be processed now. No threads, no clock of its own.
#pragma once

#include "engine/runner/runner.h"

namespace svoscope {

class Playback {
 public:
  /// Takes the commands that concern playback; others are ignored.
  void handle(const Command& command);
  /// True if another frame is wanted.
  bool wantsFrame() const { return mode_ != Mode::paused; }
  /// Pauses if the frame just processed is what was waited for.
  void processed(const FrameRecord& record, bool started);
  void finish() { mode_ = Mode::paused; }
  bool playing() const { return mode_ != Mode::paused; }
  /// Frames per second wanted, 0 = as fast as possible.
  double speed() const { return speed_; }

 private:
  enum class Mode { paused, step, play, to_frame, to_keyframe, to_loss, to_start };
  Mode mode_ = Mode::paused;
  int target_ = -1;
  double speed_ = 0;
};

}  // namespace svoscope
