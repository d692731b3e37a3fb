// SPDX-License-Identifier: MIT
#include "engine/io/lab_writer.h"

#include <fmt/format.h>

#include "engine/io/csv.h"
#include "engine/io/png.h"
#include "engine/io/rule_plots.h"
#include "engine/io/text_output.h"

namespace svoscope {

namespace {

std::string labCsv(const LabResult& result) {
  std::string csv =
      "rule,median_updates,median_relative_error,wrong_at_recall_0.8,wrong_at_recall_0.6,p90_"
      "relative_error,"
      "median_nees,converged,hopeless_converged\n";
  for (const LabRow& r : result.rows) {
    csv += fmt::format("{},{},{},{},{},{},{},{:.6g},{:.6g}\n", r.rule, csvNumber(r.median_updates),
                       csvNumber(r.median_relative_error), csvNumber(r.wrong_at_80),
                       csvNumber(r.wrong_at_60), csvNumber(r.p90_relative_error),
                       csvNumber(r.median_nees), r.converged, r.hopeless_converged);
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

template <typename Value>
LinePlot curvePlot(const LabResult& result, const std::string& title, const std::string& unit,
                   const Value& value) {
  return rulePlot(result.rows, title, "Measurements of a seed", unit,
                  [&](const LabRow& row, LineSeries& s) {
                    for (const LabCurvePoint& p : row.curve) {
                      s.x.push_back(p.update);
                      s.y.push_back(value(p));
                    }
                  });
}

LinePlot sweepPlot(const LabResult& result) {
  return rulePlot(result.rows, "What a gate on the inlier ratio lets through",
                  "Recall of the seeds that can converge right", "Wrong among accepted (fraction)",
                  [](const LabRow& row, LineSeries& s) {
                    for (const GatePoint& p : row.sweep) {
                      if (p.recall < 0.05) continue;  // a handful of seeds: noise
                      s.x.push_back(p.recall);
                      s.y.push_back(p.wrong);
                    }
                  });
}

}  // namespace

Status writeLab(const std::filesystem::path& folder, const LabResult& result) {
  Status status = makeFolder(folder);
  if (status.ok()) status = writeWhole(folder / "lab.csv", labCsv(result));
  if (status.ok()) status = writeWhole(folder / "curves.csv", curvesCsv(result));
  if (!status.ok()) return status;
  LinePlot error = curvePlot(result, "Median error of the inverse depth", "|mu - truth| (1/m)",
                             [](const LabCurvePoint& p) { return p.median_error; });
  LinePlot sigma = curvePlot(result, "Median standard deviation", "sigma (1/m)",
                             [](const LabCurvePoint& p) { return p.median_sigma; });
  error.log_y = sigma.log_y = true;
  const LinePlot converged = curvePlot(result, "Converged seeds", "Fraction",
                                       [](const LabCurvePoint& p) { return p.converged; });
  return writePng(folder / "lab.png", drawRaster({error, sigma, converged, sweepPlot(result)}, 2));
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
