// SPDX-License-Identifier: MIT
// How far measurements are from beliefs by KL and by JS, and what the two rules make of them.
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/palette.h"
#include "ui/panels/filter/divergence_charts.h"
#include "ui/panels/panel.h"
#include "ui/panels/panel_context.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"

namespace svoscope::ui {

namespace {

// After a reset the same ids are other seeds.
void forgetBrushOfOldRun(PanelContext& c) {
  DivergenceOptions& o = c.runOptions<DivergenceOptions>();
  if (std::exchange(o.generation, c.caches.run.generation()) != c.caches.run.generation())
    o.brushed = false;
}

void applyBrush(PanelContext& c, const std::vector<UpdatePoint>& points) {
  DivergenceOptions& o = c.runOptions<DivergenceOptions>();
  if (!o.brush_changed) return;
  o.brush_changed = false;
  c.state.highlighted.clear();
  if (!o.brushed) return;
  for (const std::int64_t id : brushed(points, o.x_lo, o.x_hi, o.y_lo, o.y_hi))
    c.state.highlighted.insert(id);
}

void toolbar(PanelContext& c, const std::vector<UpdatePoint>& points, bool complete) {
  DivergenceOptions& o = c.runOptions<DivergenceOptions>();
  const FilterStats& stats = c.cache<FilterStats>();
  if (button("Run so far", {"All measurements read from the history"}, o.whole_run))
    o.whole_run = o.brush_changed = true;
  ImGui::SameLine(0, grid(0.5f));
  if (button("This frame", {"Measurements that came with the viewed frame"}, !o.whole_run)) {
    o.whole_run = false;
    o.brush_changed = true;
  }
  sameLineIfFits(buttonWidth("Clear brush"));
  if (button("Clear brush",
             {"Highlight no seeds",
              o.brushed ? nullptr : "Drag a rectangle in the scatter to highlight seeds"})) {
    o.brushed = false;
    c.state.highlighted.clear();
  }
  sameLineIfFits(buttonWidth("Export CSV"));
  if (button("Export CSV", {"The measurements shown, one per row",
                            points.empty() ? "There are none" : nullptr})) {
    exportText(c, "divergences.csv", statsCsv(points));
  }
  std::string text;
  if (o.whole_run) {
    text = format("%d measurements in frames %d to %d", stats.measurements(),
                  std::max(0, stats.first()), stats.next() - 1);
    if (static_cast<std::size_t>(stats.measurements()) > points.size()) {
      text += format(", the newest %d one by one", static_cast<int>(points.size()));
    }
    if (!complete) text += ", still reading";
  } else {
    text = format("%d measurements in frame %d", static_cast<int>(points.size()), c.viewedFrame());
  }
  if (o.brushed)
    text += format(", %d seeds highlighted", static_cast<int>(c.state.highlighted.size()));
  sameLineIfFits(ImGui::CalcTextSize(text.c_str()).x);
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", text.c_str());
}

void draw(PanelContext& c) {
  if (!c.latest) {
    saysWhyEmpty(c);
    return;
  }
  forgetBrushOfOldRun(c);
  FilterStats& stats = c.cache<FilterStats>();
  const bool complete = stats.update(c.run, c.latest);
  DivergenceView& view = c.cache<DivergenceView>();
  view.update(c);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {grid(1.5f), grid(0.5f)});
  toolbar(c, view.points, complete);
  ImGui::PopStyleVar();
  if (view.points.empty()) {
    return emptyState(c.runOptions<DivergenceOptions>().whole_run
                          ? "No measurement of a seed yet"
                          : "No seed was measured in this frame",
                      "Seeds are measured once the two-view start succeeded");
  }
  applyBrush(c, view.points);
  divergenceCharts(c, view);
}

std::string csv(PanelContext& c) {
  if (!c.latest) return "";
  c.cache<FilterStats>().update(c.run, c.latest);
  DivergenceView& view = c.cache<DivergenceView>();
  view.update(c);
  return view.points.empty() ? std::string() : statsCsv(view.points);
}

std::vector<PanelOption> scriptOptions() {
  return {runOption<DivergenceOptions>("divergence.whole_run", &DivergenceOptions::whole_run)};
}

}  // namespace

extern const Panel kDivergencePanel{"KL / JS", draw, csv, /*charts=*/true, scriptOptions};

}  // namespace svoscope::ui
