// SPDX-License-Identifier: MIT
// What a plot draws within its axes; internal to the plot.
#pragma once

#include "ui/widgets/controls.h"
#include "ui/widgets/plot.h"

namespace svoscope::ui {

struct PlotFrame {
  ImDrawList* list = nullptr;
  ImVec2 lo, hi;  ///< data area
  Axis x, y;
};

Swatch swatchOf(const PlotSeries& series);
bool visible(const PlotSeries& series, const PlotState& state);
/// Whether a visible series has a value that can be drawn within the range of frames.
bool hasValues(const PlotSpec& spec, const PlotState& state, const Range& window);

void drawAxes(const PlotFrame& frame, const PlotSpec& spec, const PlotState& state);
/// Series, levels and marks, clipped by the caller.
void drawContent(const PlotFrame& frame, const PlotSpec& spec, const PlotState& state);
/// Line and tooltip at the mouse.
void hoverReadOut(const PlotFrame& frame, const PlotSpec& spec, const PlotState& state);

}  // namespace svoscope::ui
