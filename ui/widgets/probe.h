// SPDX-License-Identifier: MIT
// Where on screen each interactive widget was drawn in the last frame. The packaged ImGui has no
// hooks for tests: wrappers of our widgets record themselves here, and scripts find them by label.
#pragma once

#include <imgui/imgui.h>

#include <optional>
#include <string>
#include <vector>

namespace svoscope::ui {

struct ProbeRect {
  ImVec2 min, max;
  ImVec2 center() const { return {(min.x + max.x) / 2, (min.y + max.y) / 2}; }
  ImVec2 size() const { return {max.x - min.x, max.y - min.y}; }
};

/// Used by the UI thread only. The host clears it at the start of each frame.
struct Probe {
  /// Records the last ImGui item under its label. The visible part counts ("Play##transport" is
  /// "Play") unless nothing is visible ("##view" is "##view"). A second widget of the same name
  /// becomes "Play#2", and so on.
  static void record(const char* label);
  /// Records any rectangle, for example "panel:Image" or "image:view".
  static void record(const std::string& label, ImVec2 min, ImVec2 max);
  static std::optional<ProbeRect> find(const std::string& label);
  static void clear();
  /// In drawing order.
  static std::vector<std::string> labels();
};

}  // namespace svoscope::ui
