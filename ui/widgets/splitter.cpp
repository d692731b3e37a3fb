// SPDX-License-Identifier: MIT
#include "ui/widgets/splitter.h"

#include <algorithm>

#include "ui/palette.h"
#include "ui/widgets/probe.h"

namespace svoscope::ui {

bool splitter(const char* label, ImVec2 lo, ImVec2 hi, bool side_by_side, float length,
              float minimum, float& ratio) {
  ImGui::SetCursorScreenPos(lo);
  ImGui::PushID(label);
  ImGui::InvisibleButton("##splitter", {std::max(1.0f, hi.x - lo.x), std::max(1.0f, hi.y - lo.y)});
  ImGui::PopID();
  Probe::record(std::string("splitter:") + label, lo, hi);
  const bool hot = ImGui::IsItemHovered() || ImGui::IsItemActive();
  if (hot) {
    ImGui::SetMouseCursor(side_by_side ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
    ImGui::GetWindowDrawList()->AddRectFilled(lo, hi, withAlpha(ink::accent, 0.5f));
  }
  if (!ImGui::IsItemActive() || length < 1) return false;
  const ImVec2 by = ImGui::GetIO().MouseDelta;
  const float delta = (side_by_side ? by.x : by.y) / length;
  const float least = std::min(0.45f, minimum / length);
  ratio = std::clamp(ratio + delta, least, 1 - least);
  return delta != 0;
}

}  // namespace svoscope::ui
