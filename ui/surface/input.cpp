// SPDX-License-Identifier: MIT
#include "ui/surface/input.h"

#include <utility>

namespace svoscope::ui {
namespace {

template <typename Switch>
void change(Switch& s, bool down) {
  s.pressed = s.pressed || (down && !s.down);
  s.down = down;
}

}  // namespace

void InputState::setKey(Key key, bool down) {
  const int i = index(key);
  if (i > 0 && i < static_cast<int>(keys_.size())) change(keys_[i], down);
}

void InputState::setButton(int button, bool down) {
  if (button >= 0 && button < static_cast<int>(buttons_.size())) change(buttons_[button], down);
}

void InputState::releaseAll() {
  keys_ = {};
  buttons_ = {};
  ctrl = shift = alt = super = false;
}

void InputState::apply(ImGuiIO& io) {
  io.MousePos = mouse;
  for (std::size_t i = 0; i < buttons_.size(); ++i) io.MouseDown[i] = buttons_[i].take();
  for (std::size_t i = 0; i < keys_.size(); ++i) io.KeysDown[i] = keys_[i].take();
  io.MouseWheelH += wheel.x;
  io.MouseWheel += wheel.y;
  io.KeyCtrl = ctrl;
  io.KeyShift = shift;
  io.KeyAlt = alt;
  io.KeySuper = super;
  if (!text.empty()) io.AddInputCharactersUTF8(text.c_str());
  text.clear();
  wheel = {0, 0};
}

void installKeyMap(ImGuiIO& io) {
  const std::pair<ImGuiKey, Key> pairs[] = {
      {ImGuiKey_Tab, Key::tab},
      {ImGuiKey_LeftArrow, Key::left},
      {ImGuiKey_RightArrow, Key::right},
      {ImGuiKey_UpArrow, Key::up},
      {ImGuiKey_DownArrow, Key::down},
      {ImGuiKey_PageUp, Key::page_up},
      {ImGuiKey_PageDown, Key::page_down},
      {ImGuiKey_Home, Key::home},
      {ImGuiKey_End, Key::end},
      {ImGuiKey_Insert, Key::insert},
      {ImGuiKey_Delete, Key::del},
      {ImGuiKey_Backspace, Key::backspace},
      {ImGuiKey_Space, Key::space},
      {ImGuiKey_Enter, Key::enter},
      {ImGuiKey_Escape, Key::escape},
      {ImGuiKey_KeyPadEnter, Key::keypad_enter},
      {ImGuiKey_A, Key::a},
      {ImGuiKey_C, keyOf('C')},
      {ImGuiKey_V, keyOf('V')},
      {ImGuiKey_X, keyOf('X')},
      {ImGuiKey_Y, keyOf('Y')},
      {ImGuiKey_Z, keyOf('Z')},
  };
  for (const auto& [named, key] : pairs) io.KeyMap[named] = index(key);
}

}  // namespace svoscope::ui
