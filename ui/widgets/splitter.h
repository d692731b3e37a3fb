// SPDX-License-Identifier: MIT
// A draggable gap between two panes.
#pragma once

#include <imgui/imgui.h>

namespace svoscope::ui {

/// `ratio` is the share of the first pane of `length` pixels; both keep at least `minimum`.
/// `side_by_side`: the panes lie left and right of each other.
bool splitter(const char* label, ImVec2 lo, ImVec2 hi, bool side_by_side, float length,
              float minimum, float& ratio);

}  // namespace svoscope::ui
