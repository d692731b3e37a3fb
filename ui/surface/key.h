// SPDX-License-Identifier: MIT
// Keys by name. The numbers are the indices of io.KeysDown on every surface, so panels and scripts
// ask ImGui::IsKeyPressed(index(Key::space)) and never see a window library.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace svoscope::ui {

/// Printable keys are their ASCII capital; the others follow from 256. ImGui 1.86 names only 22
/// keys itself, the rest of KeysDown is ours to number.
enum class Key : int {
  none = 0,
  space = ' ',
  apostrophe = '\'',
  comma = ',',
  minus = '-',
  period = '.',
  slash = '/',
  digit0 = '0',  ///< digits and letters by arithmetic or keyOf('7')
  semicolon = ';',
  equal = '=',
  a = 'A',
  left_bracket = '[',
  backslash = '\\',
  right_bracket = ']',
  grave = '`',
  escape = 256,
  enter,
  tab,
  backspace,
  insert,
  del,
  right,
  left,
  down,
  up,
  page_up,
  page_down,
  home,
  end,
  f1 = 290,
  f12 = 301,
  keypad_enter = 335,
};

constexpr int index(Key key) { return static_cast<int>(key); }
/// Key of a letter or digit.
constexpr Key keyOf(char c) { return static_cast<Key>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c); }

/// A key with its modifiers, and the character it types if any.
struct KeyChord {
  Key key = Key::none;
  bool ctrl = false, shift = false, alt = false;
  char character = 0;
};

/// "space", "right", "ctrl+s", "f1", "p", "?" (US layout); nothing if unknown.
std::optional<KeyChord> parseKey(const std::string& text);
/// Names of the keys that are more than one character long, for messages.
std::vector<std::string> keyNames();

}  // namespace svoscope::ui
