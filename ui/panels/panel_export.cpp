// SPDX-License-Identifier: MIT
#include "ui/panels/panel_export.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

#include "engine/io/text_output.h"
#include "ui/palette.h"
#include "ui/panels/compare/compare_panel.h"
#include "ui/panels/export.h"
#include "ui/panels/seed/seed_charts.h"

namespace svoscope::ui {

namespace {

using Csv = std::string (*)(PanelContext&);

/// Empty: nothing to show yet.
std::string seedCsv(PanelContext& c) {
  const ViewedUpdate v = viewedUpdate(c);
  return v.trace && !v.trace->updates.empty() ? traceCsv(*v.trace) : std::string();
}

std::string searchCsv(PanelContext& c) {
  const ViewedUpdate v = viewedUpdate(c);
  if (!v.trace || !v.update || !v.trace->last) return "";
  const SearchDetail* d =
      c.caches.search.find(c.runner, *v.trace->last, *v.update, v.index,
                           v.trace->published[static_cast<std::size_t>(v.index)]);
  return d ? profileCsv(*d, v.update->seed_id, v.update->frame_index) : std::string();
}

std::string divergencesCsv(PanelContext& c) {
  if (!c.latest) return "";
  c.caches.filter.update(c.runner, c.latest);
  c.caches.divergence.update(c);
  return c.caches.divergence.points.empty() ? std::string() : statsCsv(c.caches.divergence.points);
}

std::string filterLabCsv(PanelContext& c) {
  c.caches.separation.update(c.state.lab.sigma, c.state.lab.tau);
  return labCsv(c.state.lab, c.caches.separation, c.caches.lab.state().result.get());
}

std::string featuresCsv(PanelContext& c) {
  if (!c.snapshot) return "";
  std::string text = "id,type,origin,status,level,x,y,x_end,y_end,depth,residual_px,observations\n";
  for (const FeatureView& f : c.snapshot->features) {
    text +=
        format("%lld,%s,%s,%s,%d,%.3f,%.3f,", static_cast<long long>(f.id), featureTypeName(f.type),
               originName(f.origin), statusName(f.status), f.level, f.px.x(), f.px.y());
    text += f.type == FeatureType::segment ? format("%.3f,%.3f", f.px_end.x(), f.px_end.y()) : ",";
    text += format(",%.6g,%.4g,%d\n", f.depth, f.residual_px, f.observations);
  }
  return text;
}

std::string pointsCsv(PanelContext& c) {
  if (!c.snapshot || !c.snapshot->points) return "";
  std::string text = "id,type,x,y,z,x_end,y_end,z_end,sigma,observations\n";
  for (const MapPointView& p : *c.snapshot->points) {
    text += format("%lld,%s,%.6g,%.6g,%.6g,", static_cast<long long>(p.id), featureTypeName(p.type),
                   p.position.x(), p.position.y(), p.position.z());
    const Vec3f& e = p.position_end;
    text += p.type == FeatureType::segment ? format("%.6g,%.6g,%.6g", e.x(), e.y(), e.z()) : ",,";
    text += format(",%.6g,%d\n", p.sigma, p.observations);
  }
  return text;
}

std::string comparison(PanelContext& c, std::string (*csv)(const CompareData&)) {
  if (c.runs.size() < 2 || c.engineFrame() < 0) return "";
  updateComparison(c);
  return csv(c.compare);
}

const std::map<std::string, Csv>& csvTable() {
  static const std::map<std::string, Csv> table{
      {"Image", featuresCsv},
      {"3-D", pointsCsv},
      {"Funnel",
       [](PanelContext& c) {
         return c.caches.run.records().empty() ? std::string() : framesCsv(c.caches.run);
       }},
      {"Plots", plotsCsv},
      {"Timing", [](PanelContext& c) { return timingCsv(c); }},
      {"Seed", seedCsv},
      {"Epipolar search", searchCsv},
      {"KL / JS", divergencesCsv},
      {"Evaluation", [](PanelContext& c) { return errorCsv(c); }},
      {"Filter lab", filterLabCsv},
      {"Compare plots", [](PanelContext& c) { return comparison(c, compareCsv); }},
      {"Compare 3-D", [](PanelContext& c) { return comparison(c, pathsCsv); }},
      {"Compare metrics",
       [](PanelContext& c) {
         if (c.runs.size() < 2 || c.engineFrame() < 0) return std::string();
         updateComparison(c);
         return metricsCsv(c.compare, !c.info.ground_truth.empty());
       }},
  };
  return table;
}

std::string number(double value) {
  return std::isfinite(value) ? format("%g", value) : std::string();
}

std::string slug(const std::string& panel) {
  std::string name;
  for (const char ch : panel) {
    if (std::isalnum(static_cast<unsigned char>(ch)))
      name += static_cast<char>(std::tolower(static_cast<unsigned char>(ch)));
    else if (!name.empty() && name.back() != '-')
      name += '-';
  }
  return name;
}

}  // namespace

bool exportsNumbers(const std::string& panel) { return csvTable().count(panel) > 0; }

bool exportsCharts(const std::string& panel) {
  static const std::set<std::string> charts{"Plots",           "Timing",       "Seed",
                                            "Epipolar search", "KL / JS",      "Evaluation",
                                            "Filter lab",      "Compare plots"};
  return charts.count(panel) > 0;
}

Result<std::string> panelCsv(PanelContext& c, const std::string& panel) {
  const auto found = csvTable().find(panel);
  if (found == csvTable().end()) {
    std::string names;
    for (const auto& [name, unused] : csvTable()) names += (names.empty() ? "" : ", ") + name;
    return usageError("the panel " + panel + " has no numbers to write", panel,
                      "as CSV there are: " + names);
  }
  std::string text = found->second(c);
  if (!text.empty()) return text;
  return usageError("the panel " + panel + " shows no numbers yet", panel,
                    "the panel says what it needs");
}

std::string exportName(const PanelContext& c, const std::string& panel,
                       const std::string& extension) {
  RunInfo info;
  info.sequence = c.info.sequence;
  info.method = panel.rfind("Compare", 0) == 0 ? "runs" : c.runs.style(c.runs.current()).name;
  return runName(info) + "_" + slug(panel) + format("_%05d", std::max(0, c.viewedFrame())) +
         extension;
}

Status writeExport(const std::filesystem::path& file, const std::string& text) {
  const Status made = file.has_parent_path() ? makeFolder(file.parent_path()) : Status(Done{});
  return made.ok() ? writeWhole(file, text) : made;
}

std::string plotsCsv(PanelContext& c) {
  const RunCache& run = c.caches.run;
  if (run.records().empty()) return "";
  const bool error = c.state.plot_groups.count("Error") > 0 && !c.info.ground_truth.empty();
  const auto& truth = c.caches.truth.state().error;
  const auto shown = [&](std::size_t i) {
    return c.state.plot_groups.count(seriesTable()[i].group) > 0;
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

std::string timingCsv(const PanelContext& c) {
  if (c.caches.run.records().empty()) return "";
  std::string text = "frame";
  for (int s = 0; s < kStageCount; ++s) text += format(",%s_ms", stageName(static_cast<Stage>(s)));
  text += "\n";
  for (const FrameRecord& r : c.caches.run.records()) {
    text += format("%d", r.index);
    for (const double ms : r.time_ms) text += format(",%.3f", ms);
    text += "\n";
  }
  return text;
}

std::string errorCsv(const PanelContext& c) {
  const TruthState& truth = c.caches.truth.state();
  const auto& records = c.caches.run.records();
  if (!truth.valid) return "";
  std::string text = "frame,timestamp,error_m\n";
  for (std::size_t i = 0; i < records.size() && i < truth.error.size(); ++i) {
    text +=
        format("%d,%.6f,", records[i].index, records[i].timestamp) + number(truth.error[i]) + "\n";
  }
  return text;
}

}  // namespace svoscope::ui
