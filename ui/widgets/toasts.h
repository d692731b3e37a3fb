// SPDX-License-Identifier: MIT
// Short messages in the corner that go away by themselves.
#pragma once

#include <imgui/imgui.h>

#include <string>
#include <vector>

namespace svoscope::ui {

struct Toast {
  std::string text;
  bool is_error = false;
  float seconds_left = 4;
  int count = 1;  ///< the same message again only counts up
};

class Toasts {
 public:
  void add(std::string text, bool is_error = false);
  void draw(ImVec2 bottom_right);
  const std::vector<Toast>& list() const { return toasts_; }

 private:
  std::vector<Toast> toasts_;
};

}  // namespace svoscope::ui
