// SPDX-License-Identifier: MIT
// Errors, inliers, times and differences of the open runs over the frames.
#include <algorithm>
#include <cmath>

#include "ui/palette.h"
#include "ui/panels/compare/compare_panel.h"
#include "ui/panels/panel.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"

namespace svoscope::ui {

namespace {

struct Quantity {
  const char* id;
  const char* label;
  std::vector<float> ComparedRun::*column;
};

constexpr Quantity kQuantities[] = {{"Compare error", "Position error, m", &ComparedRun::error},
                                    {"Compare inliers", "Inliers", &ComparedRun::inliers},
                                    {"Compare time", "Tracking time, ms", &ComparedRun::time_ms},
                                    {"Compare difference", "", &ComparedRun::difference}};

bool anyFinite(const std::vector<float>& values) {
  return std::any_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); });
}

std::vector<PlotMark> lossMarks(const CompareData& data) {
  std::vector<PlotMark> marks;
  int cross = 0;  // a row for each run: losses of the same frame stay apart
  for (const ComparedRun& run : data.runs()) {
    for (const int row : run.losses) {
      marks.push_back({run.frames[static_cast<std::size_t>(row)], run.style.color,
                       run.style.label + " lost", cross});
    }
    cross += !run.losses.empty();
  }
  return marks;
}

PlotSpec specOf(PanelContext& c, const CompareData& data, const Quantity& q) {
  PlotSpec spec;
  spec.id = q.id;
  const std::string current = c.runs.style(c.runs.current()).label;
  spec.y_label =
      *q.label ? q.label
               : format("Distance from %s, %s", current.c_str(), data.metric() ? "m" : "map units");
  spec.zero_based = true;
  spec.cursor = c.viewedFrame();
  for (const ComparedRun& run : data.runs()) {
    const std::vector<float>& y = run.*q.column;
    if (!anyFinite(y)) continue;
    PlotSeries series{run.style.label, &run.frames, &y, run.style.color};
    series.dashed = run.style.dash != Dash::solid;
    series.dotted = run.style.dash == Dash::dotted;
    spec.series.push_back(series);
  }
  if (q.column == &ComparedRun::time_ms && c.info.rate_hz > 0) {
    spec.levels.push_back({1000 / c.info.rate_hz, ink::dim, "frame budget"});
  }
  return spec;
}

void draw(PanelContext& c) {
  if (!comparing(c)) return;
  const CompareData& data = c.compare;
  if (c.engineFrame() < 0) return emptyState("No samples yet", "Every frame adds one to each plot");
  const std::vector<PlotMark> marks = lossMarks(data);
  std::vector<PlotSpec> specs;
  for (const Quantity& q : kQuantities) {
    if (q.column == &ComparedRun::error && c.info.ground_truth.empty()) continue;
    specs.push_back(specOf(c, data, q));
    specs.back().marks = &marks;
  }
  const float room = ImGui::GetContentRegionAvail().y;
  const int count = static_cast<int>(specs.size());
  for (int i = 0; i < count; ++i) {
    PlotSpec& spec = specs[static_cast<std::size_t>(i)];
    spec.size = {0, stackedHeight(i, count, room, ImGui::GetFontSize() * 4.2f)};
    spec.show_x_labels = i + 1 == count;
    PlotState& state = c.state.plots[spec.id];
    const PlotResult result = plot(spec, state, c.state.linked_x);
    if (result.clicked) c.view(std::max(0, static_cast<int>(result.clicked_x)));
    if (result.export_csv) {
      exportText(c, std::string(spec.id) + ".csv", plotCsv(spec, state, c.state.linked_x));
    }
  }
}

std::string csv(PanelContext& c) {
  return updateComparison(c) ? compareCsv(c.compare) : std::string();
}

}  // namespace

extern const Panel kComparePlotsPanel{"Compare plots", draw, csv, /*charts=*/true};

}  // namespace svoscope::ui
