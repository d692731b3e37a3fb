// SPDX-License-Identifier: MIT
// Keyboard shortcuts: which key does what, in one table that the help panel shows, too.
#pragma once

#include <vector>

#include "ui/surface/key.h"

namespace svoscope::ui {

enum class Action {
  none,
  play_pause,
  step,
  back,
  next_keyframe,
  first,
  live,
  next_loss,
  follow,
  screenshot,
  zoom_in,
  zoom_out,
  layout_1,
  layout_2,
  layout_3,
  layout_4,
  layout_5,
  layout_6,
  next_run,
  previous_run,
  previous_update,
  next_update,
  help,
  clear,
};

struct Shortcut {
  const char* keys;  ///< as shown
  const char* what;
  Key key;
  bool shift;
  Action action;
};

const std::vector<Shortcut>& shortcuts();

/// Actions whose keys went down in this frame; none while text is typed.
std::vector<Action> pressedActions();

}  // namespace svoscope::ui
