// SPDX-License-Identifier: MIT
// When to draw the next frame. With a GPU: 60 times a second while something moves. With a
// software renderer every frame is taken from the engine's cores, so the UI draws only for input
// and new snapshots, and while the engine plays spends at most a fifth of one core.
#pragma once

namespace svoscope::ui {

class FramePacer {
 public:
  explicit FramePacer(bool software_rendering) : software_(software_rendering) {}

  struct Situation {
    bool input = false;  ///< the user did something since the last frame
    bool new_snapshot = false;
    bool playing = false;  ///< the engine is at work
  };
  /// Is a frame due at time `now` (seconds, any origin)?
  bool due(const Situation& situation, double now) const;
  void drawn(const Situation& situation, double now, double cost);
  /// How long to wait for input before asking again.
  double patience(const Situation& situation, double now) const;

 private:
  double interval(const Situation& situation) const;

  bool software_;
  double last_ = -1e9, cost_ = 0;
  int settling_ = 3;  // hover and automatic sizes need frames after the last input
};

/// Lowers the priority of the calling thread, so that drawing yields to the engine.
void yieldToEngine();

}  // namespace svoscope::ui
