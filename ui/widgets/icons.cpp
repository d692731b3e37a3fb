// SPDX-License-Identifier: MIT
#include "ui/widgets/icons.h"

#include <algorithm>
#include <cmath>

#include "ui/theme.h"
#include "ui/widgets/figure.h"
#include "ui/widgets/pen.h"

namespace svoscope::ui {

namespace {

void triangle(ImVec2 c, float r, float direction, ImU32 color) {
  const ImVec2 tip{c.x + direction * r, c.y};
  const ImVec2 top{c.x - direction * r * 0.8f, c.y - r},
      bottom{c.x - direction * r * 0.8f, c.y + r};
  ImGui::GetWindowDrawList()->AddTriangleFilled(tip, top, bottom, color);
}

void bar(float x, float y, float half_width, float half_height, ImU32 color) {
  ImGui::GetWindowDrawList()->AddRectFilled({x - half_width, y - half_height},
                                            {x + half_width, y + half_height}, color);
}

void arrowCircle(ImVec2 c, float r, ImU32 color) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->PathArcTo(c, r * 0.85f, 0.4f, 5.2f, 20);
  list->PathStroke(color, 0, std::max(1.5f, r * 0.28f));
  const ImVec2 tip{c.x + r * 0.85f * std::cos(5.2f), c.y + r * 0.85f * std::sin(5.2f)};
  list->AddTriangleFilled({tip.x + r * 0.65f, tip.y + r * 0.15f},
                          {tip.x - r * 0.35f, tip.y + r * 0.45f},
                          {tip.x + r * 0.1f, tip.y - r * 0.55f}, color);
}

}  // namespace

void drawIcon(Icon icon, ImVec2 c, float r, ImU32 color) {
  const float w = std::max(1.0f, r * 0.22f);
  switch (icon) {
    case Icon::play:
      return triangle(c, r, 1, color);
    case Icon::pause:
      bar(c.x - r * 0.45f, c.y, r * 0.26f, r, color);
      return bar(c.x + r * 0.45f, c.y, r * 0.26f, r, color);
    case Icon::step:
      triangle({c.x + r * 0.2f, c.y}, r * 0.9f, 1, color);
      return bar(c.x - r * 0.9f, c.y, w, r * 0.9f, color);
    case Icon::back:
      triangle({c.x - r * 0.2f, c.y}, r * 0.9f, -1, color);
      return bar(c.x + r * 0.9f, c.y, w, r * 0.9f, color);
    case Icon::first:
      triangle({c.x + r * 0.3f, c.y}, r * 0.9f, -1, color);
      return bar(c.x - r * 0.9f, c.y, w, r * 0.9f, color);
    case Icon::last:
    case Icon::next_key:
      triangle({c.x - r * 0.3f, c.y}, r * 0.9f, 1, color);
      return bar(c.x + r * 0.9f, c.y, w, r * 0.9f, color);
    case Icon::reset:
      return arrowCircle(c, r, color);
    case Icon::none:
      return;
  }
}

void drawSwatch(Swatch kind, ImVec2 c, float r, ImU32 color) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float t = dp(1.5f);
  switch (kind) {
    case Swatch::square:
      return pen::rect(list, {c.x - r, c.y - r}, {c.x + r, c.y + r}, color, 0, 0, t);
    case Swatch::line:
      return pen::line(list, {c.x - r * 1.3f, c.y}, {c.x + r * 1.3f, c.y}, color, dp(2));
    case Swatch::dashed:
      pen::line(list, {c.x - r * 1.3f, c.y}, {c.x - r * 0.2f, c.y}, color, dp(2));
      return pen::line(list, {c.x + r * 0.4f, c.y}, {c.x + r * 1.3f, c.y}, color, dp(2));
    case Swatch::dotted:
      for (const float at : {-1.2f, -0.4f, 0.4f, 1.2f})
        pen::circleFilled(list, {c.x + r * at, c.y}, dp(1.2f), color, 8);
      return;
    case Swatch::cross:
      pen::line(list, {c.x - r, c.y - r}, {c.x + r, c.y + r}, color, t);
      return pen::line(list, {c.x - r, c.y + r}, {c.x + r, c.y - r}, color, t);
    case Swatch::ring:
      return pen::circle(list, c, r * 0.85f, color, 12, t);
    case Swatch::dot:
      return pen::circleFilled(list, c, r * 0.7f, color, 10);
  }
}

void dashedLine(ImDrawList* list, const std::vector<ImVec2>& points, ImU32 color, float thickness,
                float on, float off) {
  if (points.size() < 2) return;
  if (off <= 0) {
    pen::polyline(list, points.data(), static_cast<int>(points.size()), color, 0, thickness);
    return;
  }
  if (Figure* figure = Figure::active()) {
    figure->polyline(points.data(), static_cast<int>(points.size()), color, thickness, false, on,
                     off);
  }
  float phase = 0;
  const float period = on + off;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const ImVec2 a = points[i - 1], b = points[i];
    const float length = std::hypot(b.x - a.x, b.y - a.y);
    if (!(length > 0) || length > 20000) continue;
    const ImVec2 d{(b.x - a.x) / length, (b.y - a.y) / length};
    for (float s = 0; s < length;) {
      const float local = std::fmod(phase + s, period);
      const float left = local < on ? on - local : period - local;
      const float e = std::min(length, s + std::max(left, 0.01f));
      if (local < on) {
        list->AddLine({a.x + d.x * s, a.y + d.y * s}, {a.x + d.x * e, a.y + d.y * e}, color,
                      thickness);
      }
      s = e;
    }
    phase = std::fmod(phase + length, period);
  }
}

void outlinedText(ImDrawList* list, ImVec2 at, ImU32 color, const char* text) {
  constexpr ImU32 shadow = IM_COL32(0, 0, 0, 210);
  pen::text(list, {at.x + 1, at.y + 1}, shadow, text);
  pen::text(list, {at.x - 1, at.y}, shadow, text);
  pen::text(list, at, color, text);
}

}  // namespace svoscope::ui
