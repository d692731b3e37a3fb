// SPDX-License-Identifier: MIT
#include "ui/widgets/plot_draw.h"

#include <algorithm>
#include <cmath>

#include "ui/palette.h"
#include "ui/theme.h"
#include "ui/widgets/axis_draw.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/pen.h"

namespace svoscope::ui {

namespace {

void drawYAxis(const PlotFrame& f) {
  const int count =
      std::max(3, static_cast<int>((f.hi.y - f.lo.y) / (ImGui::GetFontSize() * 1.7f)));
  drawYTicks(f.list, f.lo, f.hi, f.y, count, [&](double tick, double step) {
    return f.y.log ? logTickLabel(tick) : tickLabel(tick, step);
  });
}

void drawXAxis(const PlotFrame& f, bool labels) {
  const int count = std::max(2, static_cast<int>((f.hi.x - f.lo.x) / (ImGui::GetFontSize() * 5)));
  const double step = std::max(1.0, niceStep(f.x.data.span(), count));
  for (double t = std::ceil(f.x.data.lo / step) * step; t <= f.x.data.hi; t += step) {
    const float x = std::round(f.x.toPixel(t));
    pen::line(f.list, {x, f.lo.y}, {x, f.hi.y}, ink::grid);
    if (!labels) continue;
    const std::string text = tickLabel(t, step);
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    const float tx = std::clamp(x - width / 2, f.lo.x - grid(2), f.hi.x - width);
    pen::text(f.list, {std::round(tx), f.hi.y + grid(0.5f)}, ink::dim, text.c_str());
  }
}

void drawBand(const PlotFrame& f, const PlotSeries& s) {
  if (!s.band_lo || !s.band_hi || s.band_lo->size() != s.x->size()) return;
  // Neighbouring pieces must not fade at their common edge.
  const ImDrawListFlags before = f.list->Flags;
  f.list->Flags &= ~ImDrawListFlags_AntiAliasedFill;
  for (std::size_t i = 1; i < s.x->size(); ++i) {
    const float a0 = (*s.band_lo)[i - 1], a1 = (*s.band_lo)[i];
    const float b0 = (*s.band_hi)[i - 1], b1 = (*s.band_hi)[i];
    if (!std::isfinite(a0 + a1 + b0 + b1)) continue;
    const float x0 = f.x.toPixel((*s.x)[i - 1]), x1 = f.x.toPixel((*s.x)[i]);
    if (x1 < f.lo.x || x0 > f.hi.x) continue;
    pen::quadFilled(f.list, {x0, f.y.toPixel(b0)}, {x1, f.y.toPixel(b1)}, {x1, f.y.toPixel(a1)},
                    {x0, f.y.toPixel(a0)}, withAlpha(s.color, 0.22f));
  }
  f.list->Flags = before;
}

void drawSeries(const PlotFrame& f, const PlotSpec& spec, const PlotState& state) {
  for (const PlotSeries& s : spec.series) {
    if (!visible(s, state)) continue;
    drawBand(f, s);
    const int n = static_cast<int>(s.x->size());
    for (const auto& run : buildRuns(s.x->data(), s.y->data(), n, f.x, f.y)) {
      if (run.size() == 1) pen::circleFilled(f.list, run[0], dp(2), s.color, 8);
      dashedLine(f.list, run, s.color, dp(1.5f), dp(s.dotted ? 1.5f : 5),
                 s.dotted || s.dashed ? dp(3) : 0);
    }
  }
}

void drawMarks(const PlotFrame& f, const PlotSpec& spec) {
  if (!spec.marks) return;
  for (const PlotMark& m : *spec.marks) {
    const float x = f.x.toPixel(m.x);
    if (x < f.lo.x || x > f.hi.x) continue;
    pen::line(f.list, {x, f.hi.y - grid(1.5f)}, {x, f.hi.y}, m.color, dp(1.5f));
    if (m.cross < 0) continue;
    pen::line(f.list, {x, f.lo.y}, {x, f.hi.y}, withAlpha(m.color, 0.35f), dp(1));
    drawSwatch(Swatch::cross, {x, f.lo.y + grid(1.5f + 2.5f * static_cast<float>(m.cross))},
               grid(1), m.color);
  }
}

void drawLevels(const PlotFrame& f, const PlotSpec& spec) {
  for (const PlotLevel& level : spec.levels) {
    const float y = std::round(f.y.toPixel(level.y));
    if (y < f.lo.y || y > f.hi.y) continue;
    dashedLine(f.list, {{f.lo.x, y}, {f.hi.x, y}}, withAlpha(level.color, 0.9f), dp(1), dp(4),
               dp(4));
    const float width = ImGui::CalcTextSize(level.label.c_str()).x;
    const float ty = y - ImGui::GetFontSize() - 1 < f.lo.y ? y + 1 : y - ImGui::GetFontSize() - 1;
    const ImVec2 at{f.lo.x + grid(1), ty};
    pen::rectFilled(f.list, {at.x - grid(0.5f), ty},
                    {at.x + width + grid(0.5f), ty + ImGui::GetFontSize()},
                    withAlpha(ink::canvas, 0.8f));
    pen::text(f.list, at, level.color, level.label.c_str());
  }
}

// Sample at or before x, within one frame of it.
float sampleAt(const PlotSeries& s, double x, bool& found) {
  const auto it = std::upper_bound(s.x->begin(), s.x->end(), static_cast<float>(x + 0.5));
  found = it != s.x->begin();
  return found ? (*s.y)[static_cast<std::size_t>(it - s.x->begin()) - 1] : 0;
}

}  // namespace

Swatch swatchOf(const PlotSeries& s) {
  return s.dotted ? Swatch::dotted : s.dashed ? Swatch::dashed : Swatch::line;
}

bool visible(const PlotSeries& s, const PlotState& state) {
  return s.x && s.y && !s.x->empty() && s.x->size() == s.y->size() && !state.hidden.count(s.label);
}

bool hasValues(const PlotSpec& spec, const PlotState& state, const Range& window) {
  return std::any_of(spec.series.begin(), spec.series.end(), [&](const PlotSeries& s) {
    if (!visible(s, state)) return false;
    for (std::size_t i = 0; i < s.x->size(); ++i) {
      const float v = (*s.y)[i];
      if (window.contains((*s.x)[i]) && std::isfinite(v) && !(state.log_y && v <= 0)) return true;
    }
    return false;
  });
}

void drawAxes(const PlotFrame& f, const PlotSpec& spec, const PlotState& state) {
  pen::rectFilled(f.list, f.lo, f.hi, ink::canvas);
  drawXAxis(f, spec.show_x_labels);
  if (hasValues(spec, state, f.x.data)) return drawYAxis(f);
  const char* none = "no value";  // numbers on the axis would be made up
  const ImVec2 size = ImGui::CalcTextSize(none);
  pen::text(
      f.list,
      {std::round((f.lo.x + f.hi.x - size.x) / 2), std::round((f.lo.y + f.hi.y - size.y) / 2)},
      ink::dim, none);
}

void drawContent(const PlotFrame& f, const PlotSpec& spec, const PlotState& state) {
  drawSeries(f, spec, state);
  if (hasValues(spec, state, f.x.data)) drawLevels(f, spec);
  drawMarks(f, spec);
}

void hoverReadOut(const PlotFrame& f, const PlotSpec& spec, const PlotState& state) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const double x = std::round(f.x.toData(mouse.x));
  const float px = f.x.toPixel(x);
  pen::line(f.list, {px, f.lo.y}, {px, f.hi.y}, withAlpha(ink::cursor, 0.35f));
  ImGui::BeginTooltip();
  ImGui::Text("Frame %.0f", x);
  for (const PlotSeries& s : spec.series) {
    bool found = false;
    const float v = visible(s, state) ? sampleAt(s, x, found) : 0;
    if (!found) continue;
    legendEntry(s.color, swatchOf(s), s.label.c_str());
    ImGui::SameLine(ImGui::GetFontSize() * 10);
    if (std::isfinite(v))
      ImGui::Text("%.4g", v);
    else
      ImGui::TextUnformatted("–");
  }
  if (spec.marks) {
    for (const PlotMark& m : *spec.marks) {
      if (std::abs(m.x - x) < 0.5 && !m.text.empty()) ImGui::TextUnformatted(m.text.c_str());
    }
  }
  ImGui::EndTooltip();
}

}  // namespace svoscope::ui
