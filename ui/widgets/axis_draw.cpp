// SPDX-License-Identifier: MIT
#include "ui/widgets/axis_draw.h"

#include <algorithm>
#include <cmath>

#include "ui/palette.h"
#include "ui/theme.h"
#include "ui/widgets/pen.h"

namespace svoscope::ui {

void drawYTicks(ImDrawList* list, ImVec2 lo, ImVec2 hi, const Axis& y_axis, int count,
                const TickText& textOf) {
  const float font = ImGui::GetFontSize();
  const auto ticks = y_axis.log ? logTicks(y_axis.data, count) : linearTicks(y_axis.data, count);
  const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : niceStep(y_axis.data.span(), count);
  float free_below = hi.y + font;  // ticks go upwards
  for (const double t : ticks) {
    const float y = std::round(y_axis.toPixel(t));
    if (y < lo.y || y > hi.y) continue;
    pen::line(list, {lo.x, y}, {hi.x, y}, ink::grid);
    const std::string text = textOf(t, step);
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    const float ty = std::round(std::clamp(y - font / 2, lo.y - font * 0.2f, hi.y - font * 0.8f));
    if (ty + font > free_below) continue;
    free_below = ty;
    pen::text(list, {lo.x - width - grid(1), ty}, ink::dim, text.c_str());
  }
}

}  // namespace svoscope::ui
