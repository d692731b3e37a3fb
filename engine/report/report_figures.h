// SPDX-License-Identifier: MIT
// The figures of a benchmark's report.
#pragma once

#include <string>
#include <vector>

#include "engine/figure/line_plot.h"
#include "engine/report/bench_results.h"
#include "engine/report/comparison.h"

namespace svoscope {

struct ReportFigure {
  std::string id;       ///< of anchors
  std::string caption;  ///< one sentence
  std::string svg;      ///< inline
};

/// How a column is drawn: our methods in their colours, variants dashed differently, others in
/// theirs.
FigureStyle systemStyle(const BenchResults& results, std::size_t system);

/// ATE of all systems by sequence, logarithmic; whiskers from the best to the worst run.
ReportFigure ateFigure(const BenchResults& results);
/// Ratio of ATE of each pair by sequence and over all.
ReportFigure ratioFigure(const BenchResults& results, const std::vector<Comparison>& comparisons);
/// Bars of one figure for our systems: "keyframes", "init_time_s", "relocalisation_time_s", ...
ReportFigure barFigure(const BenchResults& results, const std::string& key,
                       const std::string& caption);

/// A small plot for each system: the typical run after alignment over ground truth, losses marked.
std::vector<std::string> trajectoryPanels(const BenchResults& results, std::size_t sequence);
/// Error over time of the typical run of each of our systems; empty if there is none.
std::string errorPanel(const BenchResults& results, std::size_t sequence);

}  // namespace svoscope
