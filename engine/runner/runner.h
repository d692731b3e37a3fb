// SPDX-License-Identifier: MIT
// Commands in, snapshots out. The same interface with and without threads: the user interface and
// the command line see nothing else of a running engine.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "engine/runner/run_view.h"

namespace svoscope {

struct Command {
  enum class Kind : std::uint8_t {
    step,  ///< process one frame, then pause
    play,
    pause,
    run_to_frame,     ///< pause after frame `frame` was processed
    run_to_keyframe,  ///< pause at the next keyframe
    run_to_loss,      ///< pause when tracking is lost
    run_to_start,     ///< pause when the two-view start succeeded
    reset,            ///< start again at the first frame with an empty map
    set_parameter,    ///< key, value; takes effect at the next frame (or reset: see ParameterView)
    set_speed,        ///< value: frames per second, "0" = as fast as possible
  };
  Kind kind = Kind::step;
  int frame = -1;
  std::string key, value;
};

/// A run that takes commands.
class Runner : public RunView {
 public:
  virtual void send(const Command& command) = 0;
  /// Synchronous runner: does pending work, one frame at most; true if a frame was processed.
  /// Threaded runner: returns false at once, work happens elsewhere.
  virtual bool pump() = 0;
};

}  // namespace svoscope
