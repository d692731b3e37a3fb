// SPDX-License-Identifier: MIT
#include <algorithm>

#include "ui/palette.h"
#include "ui/panels/panel.h"
#include "ui/panels/panel_context.h"
#include "ui/panels/run/run_options.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"

namespace svoscope::ui {

namespace {

void chooser(PanelContext& c) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {grid(1), grid(1)});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {grid(1.5f), grid(0.5f)});
  OptionBar bar(ImGui::GetContentRegionAvail().y < ImGui::GetFontSize() * 11);
  for (const ChartInfo& chart : chartTable()) {
    if (std::string("Error") == chart.group && c.info.ground_truth.empty()) continue;
    const bool was = c.options<PlotsOptions>().groups.count(chart.group) > 0;
    bool on = was;
    const std::string label = std::string(chart.group) + "##chart";
    bar.item(label.c_str(), on, chart.unit_label);
    if (on && !was) c.options<PlotsOptions>().groups.insert(chart.group);
    if (!on && was) c.options<PlotsOptions>().groups.erase(chart.group);
  }
  ImGui::PopStyleVar(2);
}

PlotSpec specOf(PanelContext& c, const ChartInfo& chart) {
  const RunCache& run = c.caches.run;
  PlotSpec spec;
  spec.id = chart.group;
  spec.y_label = chart.unit_label;
  spec.zero_based = chart.zero_based;
  spec.marks = &run.marks();
  spec.cursor = c.viewedFrame();
  const std::string group = chart.group;
  if (group == "Error") {
    spec.series.push_back({methodName(c.info.method), &run.frames(), &c.caches.truth.state().error,
                           methodColor(c.info.method)});
    return spec;
  }
  const auto& table = seriesTable();
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (group != table[i].group) continue;
    spec.series.push_back(
        {table[i].label, &run.frames(), &run.column(i), table[i].color, table[i].dashed});
  }
  if (const int required = group == "Features" ? run.requiredAt(c.viewedFrame()) : 0) {
    spec.levels.push_back({1.0 * required, okabe::vermillion, "lost below"});
  }
  if (group == "Time" && c.info.rate_hz > 0) {
    spec.levels.push_back({1000 / c.info.rate_hz, ink::dim, "frame budget"});
  }
  return spec;
}

std::string fileName(const char* group) {
  std::string name = std::string("plot_") + group + ".csv";
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char ch) { return std::tolower(ch); });
  return name;
}

void draw(PanelContext& c) {
  chooser(c);
  if (c.caches.run.records().empty()) {
    return emptyState("No samples yet", "Every processed frame adds one to each plot");
  }
  std::vector<const ChartInfo*> charts;
  for (const ChartInfo& chart : chartTable()) {
    const bool known = std::string("Error") != chart.group || !c.info.ground_truth.empty();
    if (known && c.options<PlotsOptions>().groups.count(chart.group)) charts.push_back(&chart);
  }
  if (charts.empty())
    return emptyState("No plot chosen", "Choose quantities with the buttons above");
  const float room = ImGui::GetContentRegionAvail().y;
  const int count = static_cast<int>(charts.size());
  for (int i = 0; i < count; ++i) {
    const ChartInfo& chart = *charts[static_cast<std::size_t>(i)];
    PlotSpec spec = specOf(c, chart);
    spec.size = {0, stackedHeight(i, count, room, ImGui::GetFontSize() * 4.8f)};
    spec.show_x_labels = i + 1 == count;
    PlotState& state = c.state.plots[chart.group];
    const PlotResult result = plot(spec, state, c.state.linked_x);
    if (result.clicked && c.latest) c.view(std::max(0, static_cast<int>(result.clicked_x)));
    if (result.export_csv) {
      exportText(c, fileName(chart.group), plotCsv(spec, state, c.state.linked_x));
    }
  }
}

std::string number(double value) {
  return std::isfinite(value) ? format("%g", value) : std::string();
}

std::string csv(PanelContext& c) {
  const RunCache& run = c.caches.run;
  if (run.records().empty()) return "";
  const bool error =
      c.options<PlotsOptions>().groups.count("Error") > 0 && !c.info.ground_truth.empty();
  const auto& truth = c.caches.truth.state().error;
  const auto shown = [&](std::size_t i) {
    return c.options<PlotsOptions>().groups.count(seriesTable()[i].group) > 0;
  };
  std::string text = "frame,timestamp";
  for (std::size_t i = 0; i < seriesTable().size(); ++i) {
    if (shown(i)) text += std::string(",") + seriesTable()[i].group + ": " + seriesTable()[i].label;
  }
  text += error ? ",Position error m\n" : "\n";
  for (std::size_t row = 0; row < run.records().size(); ++row) {
    text += format("%d,%.6f", run.records()[row].index, run.records()[row].timestamp);
    for (std::size_t i = 0; i < seriesTable().size(); ++i) {
      if (shown(i)) text += "," + number(run.column(i)[row]);
    }
    if (error) text += "," + (row < truth.size() ? number(truth[row]) : std::string());
    text += "\n";
  }
  return text;
}

}  // namespace

extern const Panel kPlotsPanel{"Plots", draw, csv, /*charts=*/true};

}  // namespace svoscope::ui
