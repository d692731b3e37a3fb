// SPDX-License-Identifier: MIT
// Mouse and keyboard gestures as sequences of frames. ImGui 1.86 looks at the input once a frame,
// so a click is a frame with the button down and one with it up.
#pragma once

#include <string>

#include "engine/runner/runner.h"
#include "ui/host.h"

namespace svoscope::ui {

class Gestures {
 public:
  Gestures(Host& host, UiContent& content, Runner* runner)
      : host_(host), content_(content), runner_(runner) {}

  /// Draws frames without rendering; a synchronous runner works on between them.
  void tick(int frames = 1);
  void render();

  void click(ImVec2 place, int button = 0, int times = 1);
  void hover(ImVec2 place);
  void drag(ImVec2 from, ImVec2 by);
  void wheel(ImVec2 place, float notches);
  void key(const KeyChord& chord);
  void type(const std::string& text);
  /// Rectangle of a widget in a frame drawn now; the error lists labels that are there.
  Result<ProbeRect> find(const std::string& label);

 private:
  void leave();

  Host& host_;
  UiContent& content_;
  Runner* runner_;
};

}  // namespace svoscope::ui
