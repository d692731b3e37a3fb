// SPDX-License-Identifier: MIT
#include "engine/io/lab_writer.h"

#include <fmt/format.h>

#include "engine/figure/chart.h"
#include "engine/io/png.h"
#include "engine/io/text_output.h"

namespace svoscope {

namespace {

/// A value that does not exist is an empty field.
std::string field(const std::optional<double>& v) { return v ? fmt::format("{:.6g}", *v) : ""; }

std::string labCsv(const LabResult& result) {
  std::string csv =
      "rule,median_updates,median_relative_error,wrong_at_recall_0.8,wrong_at_recall_0.6,p90_"
      "relative_error,"
      "median_nees,converged,hopeless_converged\n";
  for (const LabRow& r : result.rows) {
    csv += fmt::format("{},{},{},{},{},{},{},{:.6g},{:.6g}\n", r.rule, field(r.median_updates),
                       field(r.median_relative_error), field(r.wrong_at_80), field(r.wrong_at_60),
                       field(r.p90_relative_error), field(r.median_nees), r.converged,
                       r.hopeless_converged);
  }
  return csv;
}

std::string curvesCsv(const LabResult& result) {
  std::string csv = "rule,update,median_abs_error_per_m,median_sigma_per_m,converged_fraction\n";
  for (const LabRow& r : result.rows) {
    for (const LabCurvePoint& p : r.curve)
      csv += fmt::format("{},{},{:.6g},{:.6g},{:.6g}\n", r.rule, p.update, p.median_error,
                         p.median_sigma, p.converged);
  }
  return csv;
}

/// Same rule, same look in every panel.
ChartSeries seriesOf(std::size_t rule, const std::string& name) {
  constexpr ChartColor kColors[] = {ChartColor::blue, ChartColor::orange, ChartColor::green,
                                    ChartColor::vermillion};
  constexpr int kDashes[] = {0, 5, 12, 0};
  return {name, kColors[rule % 4], kDashes[rule % 4], {}, {}};
}

template <typename Value>
ChartPanel curvePanel(const LabResult& result, const std::string& title, const std::string& unit,
                      const Value& value) {
  ChartPanel panel{title, "Measurements of a seed", unit, {}, false, true};
  for (std::size_t i = 0; i < result.rows.size(); ++i) {
    ChartSeries s = seriesOf(i, result.rows[i].rule);
    for (const LabCurvePoint& p : result.rows[i].curve) {
      s.x.push_back(p.update);
      s.y.push_back(value(p));
    }
    panel.series.push_back(std::move(s));
  }
  return panel;
}

ChartPanel sweepPanel(const LabResult& result) {
  ChartPanel panel{"What a gate on the inlier ratio lets through",
                   "Recall of the seeds that can converge right",
                   "Wrong among accepted (fraction)",
                   {},
                   false,
                   true};
  for (std::size_t i = 0; i < result.rows.size(); ++i) {
    ChartSeries s = seriesOf(i, result.rows[i].rule);
    for (const GatePoint& p : result.rows[i].sweep) {
      if (p.recall < 0.05) continue;  // a handful of seeds: noise
      s.x.push_back(p.recall);
      s.y.push_back(p.wrong);
    }
    panel.series.push_back(std::move(s));
  }
  return panel;
}

}  // namespace

Status writeLab(const std::filesystem::path& folder, const LabResult& result) {
  Status status = makeFolder(folder);
  if (status.ok()) status = writeWhole(folder / "lab.csv", labCsv(result));
  if (status.ok()) status = writeWhole(folder / "curves.csv", curvesCsv(result));
  if (!status.ok()) return status;
  ChartPanel error = curvePanel(result, "Median error of the inverse depth", "|mu - truth| (1/m)",
                                [](const LabCurvePoint& p) { return p.median_error; });
  ChartPanel sigma = curvePanel(result, "Median standard deviation", "sigma (1/m)",
                                [](const LabCurvePoint& p) { return p.median_sigma; });
  error.log_y = sigma.log_y = true;
  const ChartPanel converged = curvePanel(result, "Converged seeds", "Fraction",
                                          [](const LabCurvePoint& p) { return p.converged; });
  return writePng(folder / "lab.png", drawCharts({error, sigma, converged, sweepPanel(result)}, 2));
}

std::string labText(const LabResult& result) {
  const auto show = [](const std::optional<double>& v, int digits) {
    return v ? fmt::format("{:.{}f}", *v, digits) : std::string("-");
  };
  std::string text = fmt::format("{:<15} {:>8} {:>12} {:>12} {:>12}\n", "rule", "updates",
                                 "rel. error", "wrong @ 0.8", "wrong @ 0.6");
  for (const LabRow& r : result.rows)
    text += fmt::format("{:<15} {:>8} {:>12} {:>12} {:>12}\n", r.rule, show(r.median_updates, 0),
                        show(r.median_relative_error, 4), show(r.wrong_at_80, 3),
                        show(r.wrong_at_60, 3));
  return text;
}

}  // namespace svoscope
