// SPDX-License-Identifier: MIT
#include "engine/io/eval_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/quantile.h"
#include "engine/figure/line_plot.h"
#include "engine/figure/system_style.h"
#include "engine/io/csv.h"
#include "engine/io/text_output.h"

namespace svoscope {

namespace {

LinePlot trajectoryPlot(const Trajectory& ground_truth, const std::vector<NamedEval>& estimates) {
  std::vector<Vec3> truth;
  for (const StampedPose& pose : ground_truth) truth.push_back(pose.T_world_cam.translation());
  const PlotPlane plane = planeOf(truth);
  LinePlot plot;
  plot.title = "Trajectories after alignment";
  plot.x_label = plane.uLabel();
  plot.y_label = plane.vLabel();
  plot.equal_axes = true;
  plot.height = 520;
  plot.series.push_back(truthPath(truth, plane));
  plot.series.back().name = "ground truth";
  plot.series.back().width = 1.2;
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    plot.series.push_back(pathOf(estimates[i].result, otherStyle(static_cast<int>(i)), plane));
    plot.series.back().name = estimates[i].name;
  }
  return plot;
}

LinePlot errorPlot(const Trajectory& ground_truth, const std::vector<NamedEval>& estimates) {
  LinePlot plot;
  plot.title = "Position error";
  const bool rows = !estimates.empty() && estimates[0].result.options.by_row;
  plot.x_label = rows ? "row" : "time since the first pose of the ground truth, s";
  plot.y_label = "error, m";
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    plot.series.push_back(seriesOf(
        estimates[i].result, otherStyle(static_cast<int>(i)),
        [&](const PoseError& e) { return e.timestamp - ground_truth.front().timestamp; },
        [](const PoseError& e) { return e.error_m; }));
    plot.series.back().name = estimates[i].name;
  }
  return plot;
}

std::string errorsCsv(const std::vector<NamedEval>& estimates) {
  std::string text = "estimate,timestamp,error_m,gt_x,gt_y,gt_z,est_x,est_y,est_z\n";
  for (const NamedEval& estimate : estimates) {
    for (const PoseError& e : estimate.result.errors) {
      text += fmt::format("{},{:.6f},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n",
                          csvQuoted(estimate.name), e.timestamp, e.error_m, e.position_gt.x(),
                          e.position_gt.y(), e.position_gt.z(), e.position_est.x(),
                          e.position_est.y(), e.position_est.z());
    }
  }
  return text;
}

}  // namespace

PlotPlane planeOf(const std::vector<Vec3>& positions) {
  if (positions.empty()) return {};
  Vec3 low = positions[0], high = positions[0];
  for (const Vec3& p : positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vec3 extent = high - low;
  int order[3] = {0, 1, 2};
  std::stable_sort(order, order + 3, [&](int a, int b) { return extent[a] > extent[b]; });
  return {order[0], order[1]};
}

std::vector<std::size_t> gapsIn(const std::vector<double>& times, double medians) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < times.size(); ++i) steps.push_back(times[i] - times[i - 1]);
  if (steps.empty()) return {};
  const double limit = medians * upperMedian(steps);
  std::vector<std::size_t> gaps;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i] > limit) gaps.push_back(i + 1);
  }
  return gaps;
}

LineSeries seriesOf(const EvalResult& result, const FigureStyle& style, const PoseValue& x,
                    const PoseValue& y, double gap_medians) {
  std::vector<double> times;
  for (const PoseError& e : result.errors) times.push_back(e.timestamp);
  const std::vector<std::size_t> gaps = gapsIn(times, gap_medians);
  LineSeries series;
  series.style = style;
  for (std::size_t i = 0; i < result.errors.size(); ++i) {
    if (std::binary_search(gaps.begin(), gaps.end(), i)) {
      series.x.push_back(NAN);
      series.y.push_back(NAN);
    }
    series.x.push_back(x(result.errors[i]));
    series.y.push_back(y(result.errors[i]));
  }
  return series;
}

LineSeries pathOf(const EvalResult& result, const FigureStyle& style, PlotPlane plane,
                  double gap_medians) {
  return seriesOf(
      result, style, [plane](const PoseError& e) { return e.position_est[plane.u]; },
      [plane](const PoseError& e) { return e.position_est[plane.v]; }, gap_medians);
}

LineSeries truthPath(const std::vector<Vec3>& positions, PlotPlane plane) {
  LineSeries series;
  for (const Vec3& p : positions) {
    series.x.push_back(p[plane.u]);
    series.y.push_back(p[plane.v]);
  }
  return series;
}

Status writeEvalPlots(const std::filesystem::path& folder, const Trajectory& ground_truth,
                      const std::vector<NamedEval>& estimates) {
  Status status = makeFolder(folder);
  if (status.ok())
    status = writeWhole(folder / "trajectories.svg",
                        drawSvg(trajectoryPlot(ground_truth, estimates)).standalone());
  if (status.ok())
    status =
        writeWhole(folder / "error.svg", drawSvg(errorPlot(ground_truth, estimates)).standalone());
  if (status.ok()) status = writeWhole(folder / "errors.csv", errorsCsv(estimates));
  return status;
}

}  // namespace svoscope
