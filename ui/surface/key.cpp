// SPDX-License-Identifier: MIT
#include "ui/surface/key.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <utility>

namespace svoscope::ui {
namespace {

const std::vector<std::pair<std::string, Key>>& namedKeys() {
  static const std::vector<std::pair<std::string, Key>> keys = {
      {"space", Key::space},    {"escape", Key::escape},
      {"esc", Key::escape},     {"enter", Key::enter},
      {"tab", Key::tab},        {"backspace", Key::backspace},
      {"insert", Key::insert},  {"delete", Key::del},
      {"right", Key::right},    {"left", Key::left},
      {"down", Key::down},      {"up", Key::up},
      {"pageup", Key::page_up}, {"pagedown", Key::page_down},
      {"home", Key::home},      {"end", Key::end},
      {"plus", Key::equal},     {"minus", Key::minus},
  };
  return keys;
}

// US layout: the unshifted and the shifted character of each key.
constexpr const char* kPlain = "`1234567890-=[]\\;',./";
constexpr const char* kShifted = "~!@#$%^&*()_+{}|:\"<>?";

bool parseCharacter(char c, KeyChord& chord) {
  if (std::isalpha(static_cast<unsigned char>(c))) {
    chord.key = keyOf(c);
    chord.shift = chord.shift || std::isupper(static_cast<unsigned char>(c));
    chord.character = chord.shift ? static_cast<char>(std::toupper(c)) : c;
    return true;
  }
  if (const char* shifted = std::strchr(kShifted, c)) {
    chord.key = static_cast<Key>(kPlain[shifted - kShifted]);
    chord.shift = true;
    chord.character = c;
    return true;
  }
  if (const char* plain = std::strchr(kPlain, c)) {
    chord.key = static_cast<Key>(c);
    chord.character = chord.shift ? kShifted[plain - kPlain] : c;
    return true;
  }
  return false;
}

bool parseName(const std::string& name, KeyChord& chord) {
  if (name.size() > 1 && name[0] == 'f' &&
      std::all_of(name.begin() + 1, name.end(), [](unsigned char c) { return std::isdigit(c); })) {
    const int number = name.size() < 4 ? std::stoi(name.substr(1)) : 0;
    chord.key = static_cast<Key>(index(Key::f1) + number - 1);
    return number >= 1 && number <= 12;
  }
  for (const auto& [known, key] : namedKeys()) {
    if (known != name) continue;
    chord.key = key;
    if (key == Key::space) chord.character = ' ';
    if (name == "plus") chord.shift = true, chord.character = '+';
    if (name == "minus") chord.character = '-';
    return true;
  }
  return false;
}

}  // namespace

std::optional<KeyChord> parseKey(const std::string& text) {
  KeyChord chord;
  std::string rest = text;
  const std::pair<const char*, bool*> modifiers[] = {
      {"ctrl+", &chord.ctrl}, {"shift+", &chord.shift}, {"alt+", &chord.alt}};
  for (bool found = true; found;) {
    found = false;
    for (const auto& [prefix, flag] : modifiers) {
      if (rest.rfind(prefix, 0) != 0) continue;
      *flag = found = true;
      rest.erase(0, std::strlen(prefix));
    }
  }
  const bool known = rest.size() == 1 ? parseCharacter(rest[0], chord) : parseName(rest, chord);
  if (!known) return std::nullopt;
  if (chord.ctrl || chord.alt) chord.character = 0;  // shortcuts type nothing
  return chord;
}

std::vector<std::string> keyNames() {
  std::vector<std::string> names;
  for (const auto& [name, key] : namedKeys()) names.push_back(name);
  names.insert(names.end(), {"f1..f12", "ctrl+", "shift+", "alt+"});
  return names;
}

}  // namespace svoscope::ui
