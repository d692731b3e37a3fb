// SPDX-License-Identifier: MIT
#include "ui/actions.h"

#include <imgui/imgui.h>

namespace svoscope::ui {

const std::vector<Shortcut>& shortcuts() {
  static const std::vector<Shortcut> table{
      {"Space", "Play or pause", Key::space, false, Action::play_pause},
      {"Right", "One frame forward", Key::right, false, Action::step},
      {"Left", "One frame back", Key::left, false, Action::back},
      {"Shift + Right", "Run to the next keyframe", Key::right, true, Action::next_keyframe},
      {"L", "Run until tracking is lost", keyOf('L'), false, Action::next_loss},
      {"Home", "Oldest frame still held", Key::home, false, Action::first},
      {"End", "Newest frame", Key::end, false, Action::live},
      {"F", "Follow the camera in 3-D", keyOf('F'), false, Action::follow},
      {"+", "Zoom the image in", Key::equal, false, Action::zoom_in},
      {"-", "Zoom the image out", Key::minus, false, Action::zoom_out},
      {",", "Update before, of the selected seed", Key::comma, false, Action::previous_update},
      {".", "Next update of the selected seed", Key::period, false, Action::next_update},
      {"R", "Next run, with several open", keyOf('R'), false, Action::next_run},
      {"Shift + R", "Run before", keyOf('R'), true, Action::previous_run},
      {"1 … 6", "Layouts", keyOf('1'), false, Action::layout_1},
      {"P", "Screenshot", keyOf('P'), false, Action::screenshot},
      {"?", "This help", Key::slash, true, Action::help},
      {"Esc", "Select nothing, close help", Key::escape, false, Action::clear},
  };
  return table;
}

namespace {

bool repeats(Action action) {
  return action == Action::step || action == Action::back || action == Action::zoom_in ||
         action == Action::zoom_out || action == Action::previous_update ||
         action == Action::next_update;
}

bool pressed(Key key, bool repeat) { return ImGui::IsKeyPressed(index(key), repeat); }

}  // namespace

std::vector<Action> pressedActions() {
  std::vector<Action> actions;
  const ImGuiIO& io = ImGui::GetIO();
  if (io.WantTextInput || io.KeyCtrl || io.KeyAlt) return actions;
  for (const Shortcut& s : shortcuts()) {
    // "+" needs Shift on most keyboards, and a key of its own on the others.
    const bool shift_matters = s.action != Action::zoom_in;
    if (shift_matters && io.KeyShift != s.shift) continue;
    if (pressed(s.key, repeats(s.action))) actions.push_back(s.action);
  }
  if (io.KeyShift) return actions;
  const Action layouts[] = {Action::layout_2, Action::layout_3, Action::layout_4, Action::layout_5,
                            Action::layout_6};
  for (int i = 0; i < 5; ++i) {
    if (pressed(keyOf(static_cast<char>('2' + i)), false)) actions.push_back(layouts[i]);
  }
  return actions;
}

}  // namespace svoscope::ui
