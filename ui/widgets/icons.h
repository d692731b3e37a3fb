// SPDX-License-Identifier: MIT
// Icons, swatches and dashed lines on an ImDrawList.
#pragma once

#include <imgui/imgui.h>

#include <vector>

#include "ui/widgets/controls.h"

namespace svoscope::ui {

void drawIcon(Icon icon, ImVec2 center, float radius, ImU32 color);
void drawSwatch(Swatch kind, ImVec2 center, float radius, ImU32 color);

/// Polyline as dashes of `on` and gaps of `off` pixels; off == 0 draws it solid.
void dashedLine(ImDrawList* list, const std::vector<ImVec2>& points, ImU32 color, float thickness,
                float on, float off);

/// Text with a dark outline, readable on any image.
void outlinedText(ImDrawList* list, ImVec2 at, ImU32 color, const char* text);

}  // namespace svoscope::ui
