// SPDX-License-Identifier: MIT
#include "ui/widgets/plot.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "ui/palette.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/pen.h"
#include "ui/widgets/probe.h"

namespace svoscope::ui {

namespace {

Swatch swatchOf(const PlotSeries& s) { return s.dotted ? Swatch::dotted : s.dashed ? Swatch::dashed : Swatch::line; }

struct Frame {
  ImDrawList* list = nullptr;
  ImVec2 lo, hi;  // data area
  Axis x, y;
};

bool visible(const PlotSeries& s, const PlotState& state) {
  return s.x && s.y && !s.x->empty() && s.x->size() == s.y->size() && !state.hidden.count(s.label);
}

void fitX(const PlotSpec& spec, LinkedX& linked) {
  if (!linked.fit) return;
  Range r{1e30, -1e30};
  for (const PlotSeries& s : spec.series) {
    if (!s.x || s.x->empty()) continue;
    r.lo = std::min<double>(r.lo, s.x->front());
    r.hi = std::max<double>(r.hi, s.x->back());
  }
  linked.range = r.lo > r.hi ? Range{0, 10} : r.span() < 1 ? Range{r.lo - 1, r.hi + 1} : r;
}

void extend(Range& all, const std::vector<float>& x, const std::vector<float>& y,
            const Range& window, bool log) {
  const auto a = std::lower_bound(x.begin(), x.end(), static_cast<float>(window.lo)) - x.begin();
  const auto b = std::upper_bound(x.begin(), x.end(), static_cast<float>(window.hi)) - x.begin();
  const Range r = finiteRange(y.data() + a, static_cast<int>(b - a), log);
  all = {std::min(all.lo, r.lo), std::max(all.hi, r.hi)};
}

void fitY(const PlotSpec& spec, PlotState& state, const Range& window) {
  if (!state.fit_y) return;
  Range all{1e300, -1e300};
  for (const PlotSeries& s : spec.series) {
    if (!visible(s, state)) continue;
    extend(all, *s.x, *s.y, window, state.log_y);
    if (s.band_lo && s.band_lo->size() == s.x->size()) extend(all, *s.x, *s.band_lo, window, state.log_y);
    if (s.band_hi && s.band_hi->size() == s.x->size()) extend(all, *s.x, *s.band_hi, window, state.log_y);
  }
  if (all.lo <= all.hi) {
    for (const PlotLevel& level : spec.levels) {
      if (state.log_y && level.y <= 0) continue;
      all = {std::min(all.lo, level.y), std::max(all.hi, level.y)};
    }
    if (spec.zero_based && !state.log_y) all.lo = std::min(all.lo, 0.0);
  }
  state.y = padded(all, 0.08, state.log_y);
  if (spec.zero_based && !state.log_y && all.lo >= 0) state.y.lo = 0;
}

std::vector<double> yTicks(const Frame& f) {
  const int count = std::max(3, static_cast<int>((f.hi.y - f.lo.y) / (ImGui::GetFontSize() * 1.7f)));
  return f.y.log ? logTicks(f.y.data, count) : linearTicks(f.y.data, count);
}

void drawAxes(const Frame& f, const PlotSpec& spec) {
  pen::rectFilled(f.list, f.lo, f.hi, ink::canvas);
  const auto ticks = yTicks(f);
  const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : 1;
  const float half = ImGui::GetFontSize() / 2;
  for (const double t : ticks) {
    const float y = std::round(f.y.toPixel(t));
    if (y < f.lo.y || y > f.hi.y) continue;
    pen::line(f.list, {f.lo.x, y}, {f.hi.x, y}, ink::grid);
    const std::string text = f.y.log && t > 0 && (t < 1e-2 || t >= 1e4) ? format("%.0e", t)
                                                     : tickLabel(t, f.y.log ? t : step);
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    const float ty = std::clamp(y - half, f.lo.y - half * 0.4f, f.hi.y - half * 1.6f);
    pen::text(f.list, {f.lo.x - width - grid(1), std::round(ty)}, ink::dim, text.c_str());
  }
  const int count = std::max(2, static_cast<int>((f.hi.x - f.lo.x) / (ImGui::GetFontSize() * 5)));
  const double x_step = std::max(1.0, niceStep(f.x.data.span(), count));
  for (double t = std::ceil(f.x.data.lo / x_step) * x_step; t <= f.x.data.hi; t += x_step) {
    const float x = std::round(f.x.toPixel(t));
    pen::line(f.list, {x, f.lo.y}, {x, f.hi.y}, ink::grid);
    if (!spec.show_x_labels) continue;
    const std::string text = tickLabel(t, x_step);
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    const float tx = std::clamp(x - width / 2, f.lo.x - grid(2), f.hi.x - width);
    pen::text(f.list, {std::round(tx), f.hi.y + grid(0.5f)}, ink::dim, text.c_str());
  }
}

void drawBand(const Frame& f, const PlotSeries& s) {
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

void drawSeries(const Frame& f, const PlotSpec& spec, const PlotState& state) {
  for (const PlotSeries& s : spec.series) {
    if (!visible(s, state)) continue;
    drawBand(f, s);
    const int n = static_cast<int>(s.x->size());
    for (const auto& run : buildRuns(s.x->data(), s.y->data(), n, f.x, f.y)) {
      if (run.size() == 1) pen::circleFilled(f.list, run[0], dp(2), s.color, 8);
      dashedLine(f.list, run, s.color, dp(1.5f), dp(s.dotted ? 1.5f : 5), s.dotted || s.dashed ? dp(3) : 0);
    }
  }
}

void drawMarks(const Frame& f, const PlotSpec& spec) {
  if (!spec.marks) return;
  for (const PlotMark& m : *spec.marks) {
    const float x = f.x.toPixel(m.x);
    if (x < f.lo.x || x > f.hi.x) continue;
    pen::line(f.list, {x, f.hi.y - grid(1.5f)}, {x, f.hi.y}, m.color, dp(1.5f));
    if (m.cross < 0) continue;
    pen::line(f.list, {x, f.lo.y}, {x, f.hi.y}, withAlpha(m.color, 0.35f), dp(1));
    drawSwatch(Swatch::cross, {x, f.lo.y + grid(1.5f + 2.5f * static_cast<float>(m.cross))}, grid(1), m.color);
  }
}

void drawLevels(const Frame& f, const PlotSpec& spec) {
  for (const PlotLevel& level : spec.levels) {
    const float y = std::round(f.y.toPixel(level.y));
    if (y < f.lo.y || y > f.hi.y) continue;
    dashedLine(f.list, {{f.lo.x, y}, {f.hi.x, y}}, withAlpha(level.color, 0.9f), dp(1), dp(4), dp(4));
    const float width = ImGui::CalcTextSize(level.label.c_str()).x;
    const float ty = y - ImGui::GetFontSize() - 1 < f.lo.y ? y + 1 : y - ImGui::GetFontSize() - 1;
    const ImVec2 at{f.lo.x + grid(1), ty};
    pen::rectFilled(f.list, {at.x - grid(0.5f), ty}, {at.x + width + grid(0.5f), ty + ImGui::GetFontSize()},
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

void hoverReadOut(const Frame& f, const PlotSpec& spec, const PlotState& state) {
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
    if (std::isfinite(v)) ImGui::Text("%.4g", v);
    else ImGui::TextUnformatted("–");
  }
  if (spec.marks) {
    for (const PlotMark& m : *spec.marks) {
      if (std::abs(m.x - x) < 0.5 && !m.text.empty()) ImGui::TextUnformatted(m.text.c_str());
    }
  }
  ImGui::EndTooltip();
}

void zoomAndPan(const Frame& f, PlotState& state, LinkedX& linked) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool vertical = io.KeyCtrl;
  if (ImGui::IsItemHovered() && io.MouseWheel != 0) {
    const double factor = std::pow(0.85, io.MouseWheel);
    if (vertical) {
      state.y = zoomed(state.y, f.y.toData(io.MousePos.y), factor, state.log_y);
      state.fit_y = false;
    } else {
      linked.range = zoomed(linked.range, f.x.toData(io.MousePos.x), factor, false);
      if (linked.range.span() < 2) linked.range.hi = linked.range.lo + 2;
      linked.fit = false;
    }
  }
  if (ImGui::IsItemActive() && ImGui::IsMouseDragging(0)) {
    const float width = std::max(1.0f, f.hi.x - f.lo.x), height = std::max(1.0f, f.hi.y - f.lo.y);
    if (io.MouseDelta.x != 0) {
      linked.range = shifted(linked.range, -io.MouseDelta.x / width, false);
      linked.fit = false;
    }
    if (vertical && io.MouseDelta.y != 0) {
      state.y = shifted(state.y, io.MouseDelta.y / height, state.log_y);
      state.fit_y = false;
    }
  }
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) linked.fit = state.fit_y = true;
}

void contextMenu(PlotState& state, LinkedX& linked, PlotResult& result) {
  if (!ImGui::BeginPopupContextItem("##plot_menu")) return;
  if (ImGui::MenuItem("Fit", "double-click")) linked.fit = state.fit_y = true;
  if (ImGui::MenuItem("Logarithmic", nullptr, &state.log_y)) state.fit_y = true;
  if (ImGui::MenuItem("Export CSV")) result.export_csv = true;
  ImGui::EndPopup();
}

void legend(const PlotSpec& spec, PlotState& state) {
  ImGui::PushStyleColor(ImGuiCol_Text, toVec4(ink::dim));
  ImGui::TextUnformatted(spec.y_label.c_str());
  pen::itemText(ink::dim, spec.y_label.c_str());
  ImGui::PopStyleColor();
  for (const PlotSeries& s : spec.series) {
    if (s.label.empty()) continue;
    sameLineIfFits(legendWidth(s.label.c_str()) + grid(2));
    const bool hidden = state.hidden.count(s.label) > 0;
    legendEntry(hidden ? ink::faint : s.color, swatchOf(s),
                s.label.c_str());
    Probe::record(std::string(spec.id) + ":" + s.label, ImGui::GetItemRectMin(),
                  ImGui::GetItemRectMax());
    tooltip(hidden ? "Click to show" : "Click to hide");
    if (ImGui::IsItemHovered() && ImGui::IsMouseClicked(0)) {
      if (hidden) state.hidden.erase(s.label);
      else state.hidden.insert(s.label);
    }
  }
}

Frame layOut(const PlotSpec& spec, const PlotState& state, const LinkedX& linked) {
  Frame f;
  f.list = ImGui::GetWindowDrawList();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float width = spec.size.x > 0 ? spec.size.x : room.x;
  const float height = std::max(spec.size.y > 0 ? spec.size.y : room.y, grid(8));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float font = ImGui::GetFontSize();
  f.lo = {std::round(at.x + font * 3.2f), std::round(at.y + grid(0.5f))};
  f.hi = {std::round(std::max(f.lo.x + 8, at.x + width - grid(1))),
          std::round(at.y + height - (spec.show_x_labels ? font + grid(1.5f) : grid(1)))};
  f.hi.y = std::max(f.hi.y, f.lo.y + 8);
  f.x = {linked.range, f.lo.x, f.hi.x, false};
  f.y = {state.y, f.hi.y, f.lo.y, state.log_y};
  return f;
}

}  // namespace

PlotResult plot(const PlotSpec& spec, PlotState& state, LinkedX& linked) {
  PlotResult result;
  ImGui::PushID(spec.id);
  const float top = ImGui::GetCursorPosY();
  legend(spec, state);
  PlotSpec below = spec;
  if (spec.size.y > 0) below.size.y = spec.size.y - (ImGui::GetCursorPosY() - top);
  fitX(spec, linked);
  fitY(spec, state, linked.range);
  const Frame f = layOut(below, state, linked);
  const ImVec2 start = ImGui::GetCursorScreenPos();
  drawAxes(f, spec);
  ImGui::SetCursorScreenPos(f.lo);
  ImGui::InvisibleButton("##area", {f.hi.x - f.lo.x, f.hi.y - f.lo.y});
  Probe::record(spec.id, f.lo, f.hi);
  pen::pushClipRect(f.list, f.lo, f.hi, true);
  drawSeries(f, spec, state);
  drawLevels(f, spec);
  drawMarks(f, spec);
  if (spec.cursor >= 0) {
    const float x = std::round(f.x.toPixel(spec.cursor));
    pen::line(f.list, {x, f.lo.y}, {x, f.hi.y}, withAlpha(ink::cursor, 0.8f), dp(1));
  }
  if (ImGui::IsItemHovered()) hoverReadOut(f, spec, state);
  pen::popClipRect(f.list);
  zoomAndPan(f, state, linked);
  const ImVec2 drag = ImGui::GetMouseDragDelta(0, 0);
  if (ImGui::IsItemDeactivated() && std::hypot(drag.x, drag.y) < 4) {
    result.clicked = true;
    result.clicked_x = std::round(f.x.toData(ImGui::GetIO().MousePos.x));
  }
  contextMenu(state, linked, result);
  ImGui::SetCursorScreenPos(start);
  ImGui::Dummy({std::max(1.0f, f.hi.x - start.x),
                std::max(1.0f, f.hi.y + (spec.show_x_labels ? ImGui::GetFontSize() + grid(1) : grid(0.5f)) - start.y)});
  ImGui::PopID();
  return result;
}

std::string plotCsv(const PlotSpec& spec, const PlotState& state, const LinkedX& linked) {
  std::vector<const PlotSeries*> columns;
  std::map<float, std::vector<float>> rows;
  for (const PlotSeries& s : spec.series) {
    if (visible(s, state)) columns.push_back(&s);
  }
  for (std::size_t c = 0; c < columns.size(); ++c) {
    for (std::size_t i = 0; i < columns[c]->x->size(); ++i) {
      const float x = (*columns[c]->x)[i];
      if (!linked.fit && !linked.range.contains(x)) continue;
      auto& row = rows[x];
      row.resize(columns.size(), NAN);
      row[c] = (*columns[c]->y)[i];
    }
  }
  std::string text = "frame";
  for (const PlotSeries* s : columns) text += "," + s->label;
  text += "\n";
  for (const auto& [x, row] : rows) {
    text += format("%g", x);
    for (const float v : row) text += std::isfinite(v) ? format(",%g", v) : ",";
    text += "\n";
  }
  return text;
}

}  // namespace svoscope::ui
