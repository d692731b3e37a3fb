// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "engine/study/rule_variants.h"
#include "ui/palette.h"
#include "ui/panels/filter/lab_view.h"
#include "ui/panels/panel_context.h"
#include "ui/theme.h"
#include "ui/widgets/chart.h"
#include "ui/widgets/controls.h"

namespace svoscope::ui {

namespace {

LineStyle styleOf(const std::string& rule) {
  const RuleVariant* variant = findRuleVariant(rule);
  if (!variant) return {};
  return {lookColor(variant->look), variant->whole ? 2 : 1.5f, variant->look.dash != Dash::solid};
}

std::vector<ChartLegend> legendOf(const LabResult& result) {
  std::vector<ChartLegend> legend;
  for (const LabRow& row : result.rows) {
    const LineStyle style = styleOf(row.rule);
    legend.push_back({row.rule, style.color, style.dashed ? Swatch::dashed : Swatch::line});
  }
  return legend;
}

ChartSpec curveSpec(const char* id, const char* title, const LabResult& result, ImVec2 size) {
  ChartSpec spec;
  spec.id = id;
  spec.title = title;
  spec.x_label = "Updates";
  spec.x = {0, std::max(2.0, static_cast<double>(result.options.updates))};
  spec.size = size;
  spec.legend = legendOf(result);
  return spec;
}

void curves(Chart& chart, const LabResult& result, double (*value)(const LabCurvePoint&)) {
  for (const LabRow& row : result.rows) {
    std::vector<float> x, y;
    for (const LabCurvePoint& p : row.curve) {
      x.push_back(static_cast<float>(p.update));
      y.push_back(static_cast<float>(value(p)));
    }
    chart.line(x, y, styleOf(row.rule));
  }
}

void convergedCurve(const LabResult& result, ImVec2 size) {
  ChartSpec spec = curveSpec("Lab converged", "Converged", result, size);
  spec.y_label = "% of the seeds that can be measured";
  spec.y = {0, 100};
  Chart chart(spec);
  curves(chart, result, [](const LabCurvePoint& p) { return 100 * p.converged; });
}

void errorCurve(const LabResult& result, ImVec2 size) {
  ChartSpec spec = curveSpec("Lab error", "Median error", result, size);
  spec.y_label = "|μ - true|, 1/m (log)";
  spec.log_y = true;
  Range r{1e30, -1e30};
  for (const LabRow& row : result.rows) {
    for (const LabCurvePoint& p : row.curve) {
      if (p.median_error > 0) r = {std::min(r.lo, p.median_error), std::max(r.hi, p.median_error)};
    }
  }
  spec.y = padded(r, 0.08, true);
  Chart chart(spec);
  curves(chart, result, [](const LabCurvePoint& p) { return p.median_error; });
}

void gateCurve(const LabResult& result, ImVec2 size) {
  ChartSpec spec;
  spec.id = "Lab wrong against recall";
  spec.title = "Gate on the inlier ratio";
  spec.x_label = "Recall";
  spec.y_label = "% wrong among accepted";
  spec.x = {0, 1};
  double top = 2;
  for (const LabRow& row : result.rows) {
    for (const GatePoint& p : row.sweep) {
      if (p.recall > 0.3) top = std::max(top, 100 * p.wrong);
    }
  }
  spec.y = {0, 1.08 * std::min(top, 40.0)};
  spec.size = size;
  spec.legend = legendOf(result);
  Chart chart(spec);
  for (const LabRow& row : result.rows) {
    std::vector<float> x, y;
    for (const GatePoint& p : row.sweep) {
      if (p.recall < 0.02) continue;  // a handful of seeds says nothing
      x.push_back(static_cast<float>(p.recall));
      y.push_back(static_cast<float>(100 * p.wrong));
    }
    chart.line(x, y, styleOf(row.rule));
  }
}

std::string percent(const std::optional<double>& v, const char* pattern = "%.1f %%") {
  return v ? format(pattern, 100 * *v) : std::string("–");
}

void table(const LabResult& result) {
  if (!ImGui::BeginTable("##lab", 7,
                         ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_NoSavedSettings |
                             ImGuiTableFlags_RowBg))
    return;
  const char* heads[] = {"Rule", "Updates", "Error", "Wrong at 0.8", "at 0.6", "NEES", "Converged"};
  const char* hints[] = {"",
                         "Median number of updates to converge",
                         "Median relative error of distance",
                         "Wrong among accepted at a recall of 0.8",
                         "At a recall of 0.6",
                         "Median of (error / σ)²; calibrated: 0.455",
                         "Of all seeds, and of those never measured right"};
  ImGui::TableNextRow();
  for (int i = 0; i < 7; ++i) {
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", heads[i]);
    if (*hints[i]) tooltip(hints[i]);
  }
  for (const LabRow& row : result.rows) {
    const auto cell = [](const std::string& text) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(text.c_str());
    };
    ImGui::TableNextRow();
    ImGui::PushStyleColor(ImGuiCol_Text, toVec4(styleOf(row.rule).color));
    cell(row.rule);
    ImGui::PopStyleColor();
    cell(row.median_updates ? format("%.0f", *row.median_updates) : "–");
    cell(percent(row.median_relative_error, "%.2f %%"));
    cell(percent(row.wrong_at_80));
    cell(percent(row.wrong_at_60));
    cell(row.median_nees ? format("%.2f", *row.median_nees) : "–");
    cell(format("%.0f %%, %.0f %%", 100 * row.converged, 100 * row.hopeless_converged));
  }
  ImGui::EndTable();
}

bool sliders(LabSettings& s, float width) {
  const float font = ImGui::GetFontSize();
  bool changed = false;
  const auto item = [&](const char* label, float& value, float lo, float hi, const char* pattern,
                        const char* hint, bool first) {
    const float w = std::clamp(width / 5 - font * 5.2f, font * 4.5f, font * 10);
    if (!first) sameLineIfFits(w + ImGui::CalcTextSize(label).x + grid(5));
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", label);
    ImGui::SameLine(0, grid(1));
    changed |= slider((std::string("##") + label).c_str(), value, lo, hi, pattern, w, hint);
  };
  item("Seeds", s.seeds, 200, 6000, "%.0f", "Size of the population", true);
  item("Outliers", s.outliers, 0, 0.6f, "%.2f",
       "Share of measurements that fall anywhere in the search window", false);
  item("Hopeless", s.hopeless, 0, 0.6f, "%.2f", "Share of seeds that never see a right measurement",
       false);
  item("Noise", s.noise, 0.05f, 2, "%.2f τ", "Standard deviation of a right measurement, in τ",
       false);
  item("Step", s.step_m, 0.002f, 0.05f, "%.3f m", "Baseline gained per frame", false);
  return changed;
}

void progressRow(PanelContext& c, const LabWorker::State& now) {
  const float font = ImGui::GetFontSize();
  if (now.running) {
    ImGui::ProgressBar(static_cast<float>(now.progress), {font * 12, 0}, "simulating");
    ImGui::SameLine();
    if (button("Cancel##lab", {"Stop, and keep what is there"}))
      c.cache<LabSimulation>().worker.cancel();
  } else if (button("Run again", {"Simulate another population of the same kind"})) {
    ++c.options<LabChoices>().random_seed;
  }
  if (!now.result) return;
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%d seeds, %d updates each", now.result->options.seeds,
                      now.result->options.updates);
}

}  // namespace

void populationSection(PanelContext& c, ImVec2 size) {
  LabSettings& s = c.options<LabSettings>();
  ImGui::BeginGroup();
  const float top = ImGui::GetCursorScreenPos().y;
  sliders(s, size.x);
  LabOptions options = labOptions(s);
  options.random_seed = c.options<LabChoices>().random_seed;
  const auto key = std::make_tuple(options.seeds, options.outliers, options.hopeless, options.noise,
                                   options.step_m, options.random_seed);
  LabSimulation& simulation = c.cache<LabSimulation>();
  if (simulation.started != key) {
    simulation.started = key;
    simulation.worker.start(options);
  }
  if (c.options<LabChoices>().wait) simulation.worker.wait();
  const LabWorker::State now = simulation.worker.state();
  progressRow(c, now);
  if (now.result) {
    table(*now.result);
    const float font = ImGui::GetFontSize();
    const bool side = size.x > font * 50;
    const float left = size.y - (ImGui::GetCursorScreenPos().y - top) - grid(3);
    const ImVec2 cell{side ? std::floor((size.x - grid(4)) / 3) : size.x,
                      std::max(font * 10, side ? left : std::floor(left / 3))};
    convergedCurve(*now.result, cell);
    if (side) ImGui::SameLine(0, grid(2));
    errorCurve(*now.result, cell);
    if (side) ImGui::SameLine(0, grid(2));
    gateCurve(*now.result, cell);
  } else {
    note("The first results come in a moment");
  }
  ImGui::EndGroup();
}

}  // namespace svoscope::ui
