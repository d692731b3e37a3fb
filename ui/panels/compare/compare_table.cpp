// SPDX-License-Identifier: MIT
// The metric table of the open runs, and their columns as text.
#include <cmath>
#include <functional>
#include <optional>

#include "ui/panels/compare/compare_data.h"
#include "ui/widgets/controls.h"

namespace svoscope::ui {

namespace {

constexpr const char* kUndefined = "–";

struct Metric {
  const char* name;
  const char* hint;
  const char* pattern;
  int better;                  ///< +1 more is better, -1 less is, 0 neither
  bool needs_truth, of_poses;  ///< of_poses: defined for a trajectory, too
  std::function<std::optional<double>(const ComparedRun&)> value;
};

std::optional<double> whenValid(const ComparedRun& r, double value) {
  return r.truth.valid ? std::optional<double>(value) : std::nullopt;
}

std::optional<double> median(const ComparedRun& r, Stage stage) {
  const StageTime& time = r.metrics.time_ms[static_cast<std::size_t>(stage)];
  return time.frames > 0 ? std::optional<double>(time.median_ms) : std::nullopt;
}

const std::vector<Metric>& metrics() {
  using R = const ComparedRun&;
  static const std::vector<Metric> table{
      {"Tracked, %", "Frames with a good pose, from the first one on", "%.1f", 1, false, true,
       [](R r) -> std::optional<double> {
         if (!r.metrics.tracked_fraction_after_init) return std::nullopt;
         return 100 * *r.metrics.tracked_fraction_after_init;
       }},
      {"Start frame", "First frame with a good pose", "%.0f", -1, false, true,
       [](R r) -> std::optional<double> {
         if (!r.metrics.init_frame) return std::nullopt;
         return *r.metrics.init_frame;
       }},
      {"Keyframes", "Taken so far", "%.0f", 0, false, false,
       [](R r) { return r.metrics.keyframes; }},
      {"Losses", "How often tracking was lost", "%.0f", -1, false, false,
       [](R r) { return r.metrics.losses; }},
      {"ATE RMSE, m", "Absolute trajectory error after alignment, frames so far", "%.4f", -1, true,
       true, [](R r) { return whenValid(r, r.truth.ate_rmse); }},
      {"ATE max, m", "Largest distance from the ground truth", "%.4f", -1, true, true,
       [](R r) { return whenValid(r, r.truth.ate_max); }},
      {"RPE, m", "Relative translation error over 1 s, RMSE", "%.4f", -1, true, true,
       [](R r) { return r.truth.rpe_pairs > 0 ? whenValid(r, r.truth.rpe_trans) : std::nullopt; }},
      {"RPE, °", "Relative rotation error over 1 s, RMSE", "%.3f", -1, true, true,
       [](R r) {
         return r.truth.rpe_pairs > 0 ? whenValid(r, r.truth.rpe_rot * 57.29577951308232)
                                      : std::nullopt;
       }},
      {"Scale", "Metres per unit of the trajectory", "%.4f", 0, true, true,
       [](R r) { return whenValid(r, r.truth.scale); }},
      {"Matched poses", "Poses with ground truth within 20 ms", "%.0f", 0, true, true,
       [](R r) { return whenValid(r, r.truth.matched); }},
      {"Tracking, ms", "Median time of the tracking thread per frame", "%.2f", -1, false, false,
       [](R r) { return median(r, Stage::tracking); }},
      {"Mapping, ms", "Median time of a mapping job", "%.2f", -1, false, false,
       [](R r) { return median(r, Stage::mapping); }},
  };
  return table;
}

/// Column of the best value; none unless there are two values that differ as shown.
int bestOf(const std::vector<std::optional<double>>& values, const std::vector<std::string>& texts,
           int better) {
  int best = -1;
  bool differ = false;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!values[i]) continue;
    if (best < 0) {
      best = static_cast<int>(i);
      continue;
    }
    const auto b = static_cast<std::size_t>(best);
    differ = differ || texts[i] != texts[b];
    if (better * (*values[i] - *values[b]) > 0) best = static_cast<int>(i);
  }
  return better != 0 && differ ? best : -1;
}

std::string number(float value) {
  return std::isfinite(value) ? format("%g", value) : std::string();
}

std::string quoted(const std::string& text) {
  return text.find_first_of(",\"") == std::string::npos ? text : "\"" + text + "\"";
}

}  // namespace

std::vector<MetricRow> metricRows(const CompareData& data, bool ground_truth) {
  std::vector<MetricRow> rows;
  for (const Metric& metric : metrics()) {
    if (metric.needs_truth && !ground_truth) continue;
    MetricRow row{metric.name, metric.hint, {}, -1};
    std::vector<std::optional<double>> values;
    for (const ComparedRun& run : data.runs()) {
      const bool defined = !run.frames.empty() && (metric.of_poses || !run.style.poses_only);
      values.push_back(defined ? metric.value(run) : std::nullopt);
      row.values.push_back(values.back() ? format(metric.pattern, *values.back()) : kUndefined);
    }
    row.best = bestOf(values, row.values, metric.better);
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string metricsCsv(const CompareData& data, bool ground_truth) {
  std::string text = "metric";
  for (const ComparedRun& run : data.runs()) text += "," + quoted(run.style.name);
  text += "\n";
  for (const MetricRow& row : metricRows(data, ground_truth)) {
    text += quoted(row.name);
    for (const std::string& value : row.values)
      text += "," + (value == kUndefined ? std::string() : value);
    text += "\n";
  }
  return text;
}

std::string compareCsv(const CompareData& data) {
  std::string text = "frame";
  int first = 1 << 30, last = -1;
  for (const ComparedRun& run : data.runs()) {
    for (const char* column :
         {"error_m", data.metric() ? "difference_m" : "difference", "inliers", "tracking_ms"}) {
      text += "," + quoted(run.style.name + " " + column);
    }
    if (run.frames.empty()) continue;
    first = std::min(first, static_cast<int>(run.frames.front()));
    last = std::max(last, static_cast<int>(run.frames.back()));
  }
  text += "\n";
  for (int frame = first; frame <= last; ++frame) {
    text += format("%d", frame);
    for (const ComparedRun& run : data.runs()) {
      const int row = rowOf(run.frames, frame);
      for (const auto* column : {&run.error, &run.difference, &run.inliers, &run.time_ms}) {
        text += "," + (row < 0 ? std::string() : number((*column)[static_cast<std::size_t>(row)]));
      }
    }
    text += "\n";
  }
  return text;
}

std::string pathsCsv(const CompareData& data) {
  std::string text = data.metric() ? "frame,run,x_m,y_m,z_m\n" : "frame,run,x,y,z\n";
  for (const ComparedRun& run : data.runs()) {
    for (std::size_t i = 0; i < run.path.size(); ++i) {
      if (!run.path[i].allFinite()) continue;
      text += format("%.0f,%s,%.6g,%.6g,%.6g\n", run.frames[i], quoted(run.style.name).c_str(),
                     run.path[i].x(), run.path[i].y(), run.path[i].z());
    }
  }
  return text;
}

}  // namespace svoscope::ui
