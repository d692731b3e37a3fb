// SPDX-License-Identifier: MIT
// The state of mouse and keyboard, filled by window callbacks or by a script. ImGui 1.86 has no
// event queue: it reads this state once a frame.
#pragma once

#include <imgui/imgui.h>

#include <array>
#include <cfloat>
#include <string>

#include "ui/surface/key.h"

namespace svoscope::ui {

class InputState {
 public:
  static ImVec2 nowhere() { return {-FLT_MAX, -FLT_MAX}; }  ///< what ImGui takes for "no mouse"

  ImVec2 mouse = nowhere();
  ImVec2 wheel{0, 0};  ///< since the last frame
  std::string text;    ///< typed since the last frame, UTF-8
  bool ctrl = false, shift = false, alt = false, super = false;

  void setKey(Key key, bool down);
  void setButton(int button, bool down);
  void releaseAll();
  /// Writes the state into io and forgets what was for one frame only. A press that was released
  /// again before this frame still shows as pressed in it.
  void apply(ImGuiIO& io);

 private:
  /// Down now, or went down since the last frame: slow frames must not lose short clicks.
  struct Switch {
    bool down = false, pressed = false;
    bool take() {
      const bool result = down || pressed;
      pressed = false;
      return result;
    }
  };
  std::array<Switch, 512> keys_;
  std::array<Switch, 3> buttons_;
};

/// Tells ImGui which of our keys are its named ones.
void installKeyMap(ImGuiIO& io);

}  // namespace svoscope::ui
