// SPDX-License-Identifier: MIT
// Figures of `svoscope eval --plots`.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/eval/evaluate.h"
#include "engine/figure/line_plot.h"

namespace svoscope {

struct NamedEval {
  std::string name;  ///< of the estimate
  EvalResult result;
};

/// The two axes along which the positions extend furthest, the further one first: 0 x, 1 y, 2 z.
struct PlotPlane {
  int u = 0, v = 2;
  const char* uLabel() const { return kLabels[u]; }
  const char* vLabel() const { return kLabels[v]; }
  static constexpr const char* kLabels[3] = {"x, m", "y, m", "z, m"};
};
PlotPlane planeOf(const std::vector<Vec3>& positions);

/// Indices before which a curve over these times is interrupted: the step is longer than so many
/// medians.
std::vector<std::size_t> gapsIn(const std::vector<double>& times, double medians = 10);

/// x or y of a series, from a matched pose.
using PoseValue = std::function<double(const PoseError&)>;

/// A series without a name over the matched poses, interrupted at gaps of so many medians.
LineSeries seriesOf(const EvalResult& result, const FigureStyle& style, const PoseValue& x,
                    const PoseValue& y, double gap_medians = 10);
/// The estimated positions in the plane, m.
LineSeries pathOf(const EvalResult& result, const FigureStyle& style, PlotPlane plane,
                  double gap_medians = 10);
/// Positions in the plane in the style of the ground truth, m.
LineSeries truthPath(const std::vector<Vec3>& positions, PlotPlane plane);

/// Writes into `folder`, made if absent: trajectories.svg (aligned estimates over ground truth in
/// the plane of largest extent), error.svg (error over time) and errors.csv (a row per match). Gaps
/// longer than ten times the usual step interrupt a curve. Output error naming the file.
Status writeEvalPlots(const std::filesystem::path& folder, const Trajectory& ground_truth,
                      const std::vector<NamedEval>& estimates);

}  // namespace svoscope
