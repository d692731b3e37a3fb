// SPDX-License-Identifier: MIT
#include "engine/io/depth_study_writer.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/io/png.h"
#include "engine/io/rule_plots.h"
#include "engine/io/text_output.h"

namespace svoscope {

namespace {

using Json = nlohmann::ordered_json;

/// Every figure of a row with its name, in the order of the columns; f takes optional<double> or
/// int.
template <typename F>
void visitRow(const DepthStudyRow& r, F&& f) {
  const auto some = [](double v) { return std::optional<double>(v); };
  f("seeds", some(r.seeds));
  f("converged", some(r.converged));
  f("rejected", some(r.rejected));
  f("unfinished", some(r.unfinished));
  f("accepted", some(r.accepted));
  f("accepted_wrong", some(r.accepted_wrong));
  f("recall", some(r.recall));
  f("median_updates", r.median_updates);
  for (std::size_t i = 0; i < r.error_quantiles.size(); ++i)
    f(fmt::format("relative_error_p{:.0f}", 100 * kErrorQuantiles[i]), r.error_quantiles[i]);
  f("wrong_at_recall_0.8", r.wrong_at_80);
  f("wrong_at_recall_0.6", r.wrong_at_60);
  f("wrong_at_recall_0.4", r.wrong_at_40);
  f("median_nees", r.median_nees);
  f("nees_inside_95", r.nees_inside_95);
  f("measurements", some(r.measurements));
  f("failures", some(r.failures));
  f("outlier_share", r.outlier_share);
  f("median_measurement_nees", r.median_measurement_nees);
}

std::string csvOf(const DepthStudyResult& result) {
  std::string header = "rule", rows;
  for (const DepthStudyRow& r : result.rows) {
    const bool first = rows.empty();
    rows += r.rule;
    visitRow(r, [&](const std::string& name, const std::optional<double>& v) {
      if (first) header += "," + name;
      rows += v ? fmt::format(",{:.6g}", *v) : ",";
    });
    rows += "\n";
  }
  return header + "\n" + rows;
}

Json jsonOf(const DepthStudyResult& result) {
  Json root = {{"sequence", result.sequence},     {"poses", result.poses_from},
               {"frames", result.frames},         {"keyframes", result.keyframes},
               {"edge_seeds", result.edge_seeds}, {"rules", Json::array()}};
  for (const DepthStudyRow& r : result.rows) {
    Json row = {{"rule", r.rule}};
    visitRow(r, [&](const std::string& name, const std::optional<double>& v) {
      row[name] = v ? Json(*v) : Json(nullptr);
    });
    Json sweep = Json::array();
    for (std::size_t i = 0; i < r.sweep.size(); i += std::max<std::size_t>(1, r.sweep.size() / 100))
      sweep.push_back({r.sweep[i].gate, r.sweep[i].recall, r.sweep[i].wrong});
    row["sweep_gate_recall_wrong"] = sweep;
    row["converged_by_age"] = r.converged_by_age;
    root["rules"].push_back(row);
  }
  return root;
}

/// Distribution function of sorted values up to `most`, as a share of `total`.
void distribution(const std::vector<double>& values, double most, double total, LineSeries& s) {
  constexpr int kSteps = 200;
  std::size_t below = 0;
  for (int i = 0; i <= kSteps; ++i) {
    const double x = most * i / kSteps;
    while (below < values.size() && values[below] <= x) ++below;
    s.x.push_back(x);
    s.y.push_back(total > 0 ? static_cast<double>(below) / total : 0);
  }
}

cv::Mat figureOf(const DepthStudyResult& result) {
  const LinePlot sweep =
      rulePlot(result.rows, "What a gate on the inlier ratio lets through",
               "Recall (right and accepted / all seeds)", "Wrong among accepted (fraction)",
               [](const DepthStudyRow& r, LineSeries& s) {
                 for (const GatePoint& p : r.sweep) {
                   if (p.recall < 0.02) continue;  // a handful of seeds: noise
                   s.x.push_back(p.recall);
                   s.y.push_back(p.wrong);
                 }
               });
  const LinePlot age = rulePlot(result.rows, "Converged seeds", "Frames since the keyframe",
                                "Fraction of all seeds", [](const DepthStudyRow& r, LineSeries& s) {
                                  for (std::size_t i = 0; i < r.converged_by_age.size(); ++i) {
                                    s.x.push_back(static_cast<double>(i));
                                    s.y.push_back(r.converged_by_age[i]);
                                  }
                                });
  const LinePlot error =
      rulePlot(result.rows, "Relative depth error of accepted seeds", "Error / depth (%)",
               "Fraction of all seeds below", [](const DepthStudyRow& r, LineSeries& s) {
                 distribution(r.errors, 0.1, r.seeds, s);
                 for (double& x : s.x) x *= 100;
               });
  LinePlot nees = rulePlot(result.rows, "Calibration of accepted seeds", "|Error| / sigma",
                           "Fraction of accepted below", [](const DepthStudyRow& r, LineSeries& s) {
                             distribution(r.normalised_errors, 6, r.accepted, s);
                           });
  LineSeries ideal;
  ideal.name = "Calibrated";
  ideal.style = {"#7f7f7f", "2 2"};
  for (double x = 0; x <= 6; x += 0.05) {
    ideal.x.push_back(x);
    ideal.y.push_back(std::erf(x / std::sqrt(2.0)));
  }
  nees.series.push_back(std::move(ideal));
  return drawRaster({sweep, age, error, nees}, 2);
}

}  // namespace

Status writeDepthStudy(const std::filesystem::path& folder, const DepthStudyResult& result) {
  Status status = makeFolder(folder);
  if (status.ok()) status = writeWhole(folder / "depth_study.csv", csvOf(result));
  if (status.ok()) status = writeWhole(folder / "depth_study.json", jsonOf(result).dump(2) + "\n");
  if (!status.ok()) return status;
  return writePng(folder / "depth_study.png", figureOf(result));
}

std::string depthStudyText(const DepthStudyResult& result) {
  const auto show = [](const std::optional<double>& v, int digits) {
    return v ? fmt::format("{:.{}f}", *v, digits) : std::string("-");
  };
  std::string text = fmt::format(
      "depth study with poses from {}: {} keyframes, {} seeds ({} at depth edges left out)\n",
      result.poses_from, result.keyframes, result.rows.empty() ? 0 : result.rows[0].seeds,
      result.edge_seeds);
  text += fmt::format("{:<15} {:>8} {:>9} {:>8} {:>8} {:>8} {:>10} {:>9} {:>9} {:>8}\n", "rule",
                      "updates", "converged", "accepted", "recall", "wrong", "error p50", "w @ 0.6",
                      "w @ 0.4", "nees p50");
  for (const DepthStudyRow& r : result.rows) {
    const std::optional<double> wrong =
        r.accepted > 0 ? std::optional<double>(static_cast<double>(r.accepted_wrong) / r.accepted)
                       : std::nullopt;
    text += fmt::format("{:<15} {:>8} {:>9} {:>8} {:>8.3f} {:>8} {:>10} {:>9} {:>9} {:>8}\n",
                        r.rule, show(r.median_updates, 0), r.converged, r.accepted, r.recall,
                        show(wrong, 3), show(r.error_quantiles[2], 4), show(r.wrong_at_60, 3),
                        show(r.wrong_at_40, 3), show(r.median_nees, 2));
  }
  return text;
}

}  // namespace svoscope
