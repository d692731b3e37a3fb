// SPDX-License-Identifier: MIT
// Draws a layout: title bars with tabs, contents, splitters between them.
#pragma once

#include <imgui/imgui.h>

#include <functional>
#include <string>

#include "ui/layout.h"

namespace svoscope::ui {

struct LayoutView {
  std::function<void(const std::string& panel)> draw_panel;
  std::string* maximized = nullptr;  ///< panel shown alone, or empty
  std::string export_clicked;        ///< panel whose button was pressed in this frame
  bool changed = false;              ///< by the user in this frame
};

/// Fills the rectangle lo..hi of the current window.
void drawLayout(Layout& layout, ImVec2 lo, ImVec2 hi, LayoutView& view);

}  // namespace svoscope::ui
