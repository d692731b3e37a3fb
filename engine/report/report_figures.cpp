// SPDX-License-Identifier: MIT
#include "engine/report/report_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/figure/svg_bars.h"
#include "engine/figure/system_style.h"
#include "engine/io/eval_plots.h"

namespace svoscope {

namespace {

constexpr double kGapMedians = 2.5;  // two frames missing are a gap

std::size_t ownOf(const BenchResults& results) { return static_cast<std::size_t>(results.own); }

std::optional<SvgBar> barOf(const BenchResults& results, std::size_t s, std::size_t m,
                            const FigureInfo& info) {
  const auto spread = results.spread(s, m, info);
  if (!spread) return std::nullopt;
  return SvgBar{spread->mean, spread->low, spread->high};
}

SvgBarChart chartOf(const BenchResults& results, const FigureInfo& info, std::size_t systems) {
  SvgBarChart chart;
  chart.title = info.label;
  chart.x_label = *info.unit ? fmt::format("{}, {}", info.label, info.unit) : info.label;
  for (std::size_t m = 0; m < systems; ++m)
    chart.series.push_back({results.systems[m].system.label, systemStyle(results, m)});
  for (std::size_t s = 0; s < results.config.sequences.size(); ++s) {
    SvgBarGroup group{results.config.sequences[s].name, {}};
    for (std::size_t m = 0; m < systems; ++m) group.bars.push_back(barOf(results, s, m, info));
    const bool any = std::any_of(group.bars.begin(), group.bars.end(),
                                 [](const auto& bar) { return bar.has_value(); });
    if (any) chart.groups.push_back(std::move(group));
  }
  return chart;
}

std::vector<Vec3> positionsOf(const Trajectory& poses) {
  std::vector<Vec3> positions;
  for (const StampedPose& pose : poses) positions.push_back(pose.T_world_cam.translation());
  return positions;
}

/// The part of the ground truth that the run goes through.
Trajectory truthOf(const SequenceFacts& facts) {
  if (facts.times.empty()) return facts.ground_truth;
  Trajectory part;
  for (const StampedPose& pose : facts.ground_truth) {
    if (pose.timestamp >= facts.times.front() - 0.1 && pose.timestamp <= facts.times.back() + 0.1)
      part.push_back(pose);
  }
  return part;
}

/// Where tracking was lost: places of the ground truth at the first frame of each loss.
std::vector<FigurePoint> lossesOf(const RunResult& run, const SequenceFacts& facts,
                                  const Trajectory& truth, PlotPlane plane) {
  std::vector<FigurePoint> marks;
  const double step = facts.times.size() > 1 ? facts.times[1] - facts.times[0] : 0;
  double previous = -1e300;
  for (const double t : run.lost) {
    if (t - previous > 1.5 * step && !truth.empty()) {
      const auto nearest = std::min_element(
          truth.begin(), truth.end(), [t](const StampedPose& a, const StampedPose& b) {
            return std::abs(a.timestamp - t) < std::abs(b.timestamp - t);
          });
      const Vec3& p = nearest->T_world_cam.translation();
      marks.push_back({p[plane.u], p[plane.v]});
    }
    previous = t;
  }
  return marks;
}

std::string pairName(const BenchResults& results, const Comparison& c) {
  return results.systems[c.a].system.label + " / " + results.systems[c.b].system.label;
}

}  // namespace

FigureStyle systemStyle(const BenchResults& results, std::size_t system) {
  const ResultSystem& s = results.systems[system];
  if (s.peer) return otherStyle(static_cast<int>(system) - results.own);
  FigureStyle style = methodStyle(s.system.method);
  static const char* kDashes[] = {"", "7 3", "2 2", "8 2 2 2"};
  static const double kOpacity[] = {1, 0.55, 0.3, 0.15};
  if (results.config.variants.size() > 1) style.dash = kDashes[s.system.variant % 4];
  style.opacity = kOpacity[s.system.variant % 4];
  return style;
}

ReportFigure ateFigure(const BenchResults& results) {
  SvgBarChart chart = chartOf(results, figure("ate_m"), results.systems.size());
  chart.title = "Absolute trajectory error";
  chart.log = true;
  chart.width = 860;
  return {"fig-ate",
          "ATE rmse: mean of the runs, whiskers from the best to the worst run; - failed, or no "
          "trajectory of it.",
          drawBars(chart).inlined()};
}

ReportFigure ratioFigure(const BenchResults& results, const std::vector<Comparison>& comparisons) {
  SvgBarChart chart;
  chart.title = "Ratio of ATE";
  chart.x_label = "ATE of the first / ATE of the second; left of 1 the first is better";
  chart.log = true;
  chart.reference = 1;
  chart.width = 860;
  std::vector<const Comparison*> shown;
  for (const Comparison& c : comparisons) {
    if (c.figure->value != &RunFigures::ate_m || c.sequences.empty()) continue;
    chart.series.push_back({pairName(results, c), otherStyle(static_cast<int>(shown.size()))});
    shown.push_back(&c);
  }
  for (std::size_t s = 0; s < results.config.sequences.size(); ++s) {
    SvgBarGroup group{results.config.sequences[s].name, {}};
    bool any = false;
    for (const Comparison* c : shown) {
      group.bars.emplace_back();
      for (const SequenceComparison& row : c->sequences) {
        if (row.sequence == s)
          group.bars.back() = SvgBar{row.ratio, row.ratios.low, row.ratios.high};
      }
      any = any || group.bars.back().has_value();
    }
    if (any) chart.groups.push_back(std::move(group));
  }
  SvgBarGroup all{"all sequences", {}};
  for (const Comparison* c : shown)
    all.bars.push_back(SvgBar{c->ratio, c->ratios.low, c->ratios.high});
  chart.groups.push_back(std::move(all));
  return {"fig-ratio",
          "Whiskers are 95 % bootstrap intervals: over the runs of a sequence, and over sequences "
          "and runs for "
          "all; single runs have none.",
          drawBars(chart).inlined()};
}

ReportFigure barFigure(const BenchResults& results, const std::string& key,
                       const std::string& caption) {
  return {"fig-" + key, caption, drawBars(chartOf(results, figure(key), ownOf(results))).inlined()};
}

std::vector<std::string> trajectoryPanels(const BenchResults& results, std::size_t s) {
  const SequenceFacts& facts = results.facts[s];
  const Trajectory truth = truthOf(facts);
  const std::vector<Vec3> places = positionsOf(truth);
  const PlotPlane plane = planeOf(places);
  std::vector<std::string> panels;
  for (std::size_t m = 0; m < results.systems.size(); ++m) {
    const RunResult* run = results.typical(s, m);
    const std::string& label = results.systems[m].system.label;
    if (results.systems[m].peer && !results.runs[s][m].front().present) continue;
    LinePlot plot;
    plot.width = 330;
    plot.height = 270;
    plot.equal_axes = true;
    plot.x_label = plane.uLabel();
    plot.y_label = plane.vLabel();
    plot.title = run && run->figures.ate_m
                     ? fmt::format("{}: ATE {:.3g} m", label, *run->figures.ate_m)
                     : fmt::format("{}: {}", label, run ? "no error known" : results.failure(s, m));
    // A reason may be a whole sentence.
    if (plot.title.size() > 44) plot.title = plot.title.substr(0, 41) + "...";
    plot.series.push_back(truthPath(places, plane));
    plot.series.back().width = 1.1;
    if (run && run->evaluation) {
      FigureStyle style = systemStyle(results, m);
      style.dash.clear();  // alone in its panel; gaps shall be losses
      plot.series.push_back(pathOf(*run->evaluation, style, plane, kGapMedians));
      plot.series.back().width = 2;
      plot.losses = lossesOf(*run, facts, truth, plane);
    }
    panels.push_back(drawSvg(plot).inlined());
  }
  return panels;
}

std::string errorPanel(const BenchResults& results, std::size_t s) {
  LinePlot plot;
  plot.title = "Position error over time";
  plot.x_label = "time since the first frame, s";
  plot.y_label = "error, m";
  plot.width = 860;
  plot.height = 240;
  const double start = results.facts[s].times.empty() ? 0 : results.facts[s].times.front();
  double low = 1e300, high = 0;
  for (std::size_t m = 0; m < ownOf(results); ++m) {
    const RunResult* run = results.typical(s, m);
    if (!run || !run->evaluation) continue;
    plot.series.push_back(seriesOf(
        *run->evaluation, systemStyle(results, m),
        [&](const PoseError& e) { return e.timestamp - start; },
        [](const PoseError& e) { return e.error_m; }, kGapMedians));
    plot.series.back().name = results.systems[m].system.label;
    low = std::min(low, run->evaluation->ate.median);
    high = std::max(high, run->evaluation->ate.max);
  }
  if (plot.series.empty()) return "";
  // One run that goes astray would press all others onto the axis.
  plot.log_y = high > 30 * low;
  if (plot.log_y) {
    for (LineSeries& series : plot.series) {
      for (double& v : series.y) {
        if (v < 1e-3 * low) v = NAN;  // a crossing of zero, not a result
      }
    }
  }
  return drawSvg(plot).inlined();
}

}  // namespace svoscope
