// SPDX-License-Identifier: MIT
#include "ui/widgets/plot.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "ui/palette.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/pen.h"
#include "ui/widgets/plot_draw.h"
#include "ui/widgets/probe.h"

namespace svoscope::ui {

namespace {

void fitX(const PlotSpec& spec, LinkedX& linked) {
  if (!linked.fit) return;
  Range r = linked.known;
  if (r.lo > r.hi) {
    r = {1e30, -1e30};
    for (const PlotSeries& s : spec.series) {
      if (!s.x || s.x->empty()) continue;
      r.lo = std::min<double>(r.lo, s.x->front());
      r.hi = std::max<double>(r.hi, s.x->back());
    }
  }
  if (r.lo > r.hi) return;  // nothing to show: what the plots beside it show
  linked.range = r.span() < 1 ? Range{r.lo - 0.5, r.hi + 0.5} : r;
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
    if (s.band_lo && s.band_lo->size() == s.x->size())
      extend(all, *s.x, *s.band_lo, window, state.log_y);
    if (s.band_hi && s.band_hi->size() == s.x->size())
      extend(all, *s.x, *s.band_hi, window, state.log_y);
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

void zoomAndPan(const PlotFrame& f, PlotState& state, LinkedX& linked) {
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
    legendEntry(hidden ? ink::faint : s.color, swatchOf(s), s.label.c_str());
    Probe::record(std::string(spec.id) + ":" + s.label, ImGui::GetItemRectMin(),
                  ImGui::GetItemRectMax());
    tooltip(hidden ? "Click to show" : "Click to hide");
    if (ImGui::IsItemHovered() && ImGui::IsMouseClicked(0)) {
      if (hidden)
        state.hidden.erase(s.label);
      else
        state.hidden.insert(s.label);
    }
  }
}

PlotFrame layOut(const PlotSpec& spec, const PlotState& state, const LinkedX& linked) {
  PlotFrame f;
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
  const PlotFrame f = layOut(below, state, linked);
  const ImVec2 start = ImGui::GetCursorScreenPos();
  drawAxes(f, spec, state);
  ImGui::SetCursorScreenPos(f.lo);
  ImGui::InvisibleButton("##area", {f.hi.x - f.lo.x, f.hi.y - f.lo.y});
  Probe::record(spec.id, f.lo, f.hi);
  pen::pushClipRect(f.list, f.lo, f.hi, true);
  drawContent(f, spec, state);
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
  ImGui::Dummy(
      {std::max(1.0f, f.hi.x - start.x),
       std::max(1.0f, f.hi.y + (spec.show_x_labels ? ImGui::GetFontSize() + grid(1) : grid(0.5f)) -
                          start.y)});
  ImGui::PopID();
  return result;
}

float stackedHeight(int index, int count, float room, float least) {
  const float labels =
      ImGui::GetFontSize() + grid(0.5f);  // of the frames, below the last plot only
  const float each = (room - labels) / static_cast<float>(count) - ImGui::GetStyle().ItemSpacing.y;
  return std::floor(std::max(least, each) + (index + 1 == count ? labels : 0));
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
