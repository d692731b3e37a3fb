// SPDX-License-Identifier: MIT
#include "ui/harness/gestures.h"

#include <algorithm>
#include <cctype>

namespace svoscope::ui {
namespace {

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// Labels that contain the one looked for; all if none does.
std::string similarLabels(const std::string& label) {
  constexpr std::size_t kMost = 40;
  std::vector<std::string> all = Probe::labels(), similar;
  std::copy_if(all.begin(), all.end(), std::back_inserter(similar), [&](const std::string& l) {
    return lower(l).find(lower(label)) != std::string::npos;
  });
  if (similar.empty()) similar = all;
  std::string text;
  for (std::size_t i = 0; i < std::min(kMost, similar.size()); ++i)
    text += (i ? ", \"" : "\"") + similar[i] + "\"";
  if (similar.size() > kMost) text += ", and " + std::to_string(similar.size() - kMost) + " more";
  return text;
}

}  // namespace

void Gestures::tick(int frames) {
  for (int i = 0; i < frames; ++i) {
    if (runner_) runner_->pump();
    host_.frame(content_, false);
  }
}

void Gestures::render() { host_.frame(content_, true); }

void Gestures::leave() {
  host_.scriptInput().mouse = InputState::nowhere();
  tick();
}

void Gestures::hover(ImVec2 place) {
  host_.scriptInput().mouse = place;
  tick(2);  // the first frame finds the window under the mouse, the second the widget
}

void Gestures::click(ImVec2 place, int button, int times) {
  InputState& input = host_.scriptInput();
  host_.skipTime(0.5f);  // two clicks in a row are not a double click
  hover(place);
  for (int i = 0; i < times; ++i) {
    input.setButton(button, true);
    tick();
    input.setButton(button, false);
    tick();
  }
  leave();
}

void Gestures::drag(ImVec2 from, ImVec2 by) {
  constexpr int kSteps = 8;  // dragging starts past a threshold: more than one move is needed
  InputState& input = host_.scriptInput();
  host_.skipTime(0.5f);
  hover(from);
  input.setButton(0, true);
  tick();
  for (int i = 1; i <= kSteps; ++i) {
    const float part = static_cast<float>(i) / kSteps;
    input.mouse = {from.x + part * by.x, from.y + part * by.y};
    tick();
  }
  input.setButton(0, false);
  tick();
  leave();
}

void Gestures::wheel(ImVec2 place, float notches) {
  InputState& input = host_.scriptInput();
  hover(place);
  const float direction = notches < 0 ? -1.0f : 1.0f;
  for (float left = std::abs(notches); left > 0; left -= 1) {
    input.wheel = {0, direction * std::min(left, 1.0f)};
    tick();
  }
  leave();
}

void Gestures::key(const KeyChord& chord) {
  InputState& input = host_.scriptInput();
  input.ctrl = chord.ctrl;
  input.shift = chord.shift;
  input.alt = chord.alt;
  input.setKey(chord.key, true);
  if (chord.character) input.text += chord.character;
  tick();
  input.setKey(chord.key, false);
  tick();
  input.ctrl = input.shift = input.alt = false;
  tick();
}

void Gestures::type(const std::string& text) {
  host_.scriptInput().text = text;
  tick(2);
}

Result<ProbeRect> Gestures::find(const std::string& label) {
  tick();
  const std::optional<ProbeRect> rect = Probe::find(label);
  if (!rect) {
    return usageError("no widget is called \"" + label + "\"", "",
                      "there are: " + similarLabels(label));
  }
  const ImVec2 center = rect->center();
  const SurfaceSize size = host_.surface().size();
  const bool inside = center.x >= 0 && center.y >= 0 && center.x < static_cast<float>(size.width) &&
                      center.y < static_cast<float>(size.height);
  if (inside) return *rect;
  return usageError("\"" + label + "\" is outside of the window", "",
                    "make the window larger with `size WxH`");
}

}  // namespace svoscope::ui
