// SPDX-License-Identifier: MIT
// What plots over frames and charts share of their axes.
#pragma once

#include <imgui/imgui.h>

#include <functional>
#include <string>

#include "ui/widgets/plot_math.h"

namespace svoscope::ui {

/// Text of a tick; `step`: to the next one, for a linear axis.
using TickText = std::function<std::string(double tick, double step)>;

/// At most `count` lines across the data area from `lo` to `hi` (pixels) with texts left of it.
/// Texts that would lie on one another are left out, their lines stay.
void drawYTicks(ImDrawList* list, ImVec2 lo, ImVec2 hi, const Axis& y, int count,
                const TickText& textOf);

}  // namespace svoscope::ui
