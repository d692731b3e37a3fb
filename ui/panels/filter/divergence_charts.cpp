// SPDX-License-Identifier: MIT
#include "ui/panels/filter/divergence_charts.h"

#include <algorithm>
#include <cmath>

#include "ui/model/seed_trace.h"
#include "ui/palette.h"
#include "ui/panels/panel_context.h"
#include "ui/widgets/chart.h"
#include "ui/widgets/rule_style.h"

namespace svoscope::ui {

void DivergenceView::update(PanelContext& c) {
  const FilterStats& stats = c.cache<FilterStats>();
  const bool whole = c.runOptions<DivergenceOptions>().whole_run;
  const TruthState& truth = c.caches.truth.state();
  const Key key{stats.version(), truth.version, whole ? -1 : c.viewedFrame(), whole};
  if (key == key_) return;
  key_ = key;
  points.clear();
  shown.clear();
  if (whole) {
    points.assign(stats.points().begin(), stats.points().end());
    shown = stats.run();
  } else if (c.snapshot) {
    points = pointsOf(*c.snapshot);
    for (const UpdatePoint& p : points) shown.add(p);
  }
  calibration = calibrate(points, truth.valid ? truth.scale : 0);
  for (const FilterRule r : kRules) {
    median[r] = stats.convergence(r, 0.5);
    low[r] = stats.convergence(r, 0.25);
    high[r] = stats.convergence(r, 0.75);
    steps[r].clear();
    for (std::size_t i = 0; i < median[r].size(); ++i)
      steps[r].push_back(static_cast<float>(i + 1));
    low[r].resize(steps[r].size(), NAN);
    high[r].resize(steps[r].size(), NAN);
  }
}

namespace {

constexpr double kLogTwo = 0.6931471805599453;
constexpr double kLeast = 1e-3, kMost = 1e4;  // nats, of the KL axis

// Bins as steps, in percent of all.
void histogram(Chart& chart, const Bins& bins, const LineStyle& style) {
  if (bins.total() == 0) return;
  std::vector<float> x, y;
  const int n = static_cast<int>(bins.counts().size());
  for (int i = 0; i < n; ++i) {
    const auto share =
        static_cast<float>(100.0 * bins.counts()[static_cast<std::size_t>(i)] / bins.total());
    for (const int edge : {i, i + 1}) {
      x.push_back(static_cast<float>(bins.edge(edge)));
      y.push_back(share);
    }
  }
  chart.area(x, y, withAlpha(style.color, 0.14f));
  chart.line(x, y, style);
  chart.markX(bins.quantile(0.5), {withAlpha(style.color, 0.9f), 1, true});
}

double tallest(const std::vector<const Bins*>& all) {
  double top = 1;
  for (const Bins* b : all) {
    for (const int n : b->counts()) top = std::max(top, b->total() ? 100.0 * n / b->total() : 0);
  }
  return 1.1 * top;
}

ChartSpec binsSpec(const char* id, const char* title, const char* x_label, const Bins& bins,
                   ImVec2 size) {
  ChartSpec spec;
  spec.id = id;
  spec.title = title;
  spec.x_label = x_label;
  spec.y_label = "% of measurements";
  spec.x = {bins.lo(), bins.hi()};
  spec.log_x = bins.log();
  spec.size = size;
  return spec;
}

double onAxis(double kl) { return std::clamp(kl, kLeast, kMost); }

void scatter(PanelContext& c, const DivergenceView& v, ImVec2 size) {
  DivergenceOptions& o = c.runOptions<DivergenceOptions>();
  ChartSpec spec;
  spec.id = "KL against JS";
  spec.title = "Each measurement";
  spec.x_label = "KL(belief || measurement), nats (log)";
  spec.y_label = "JS, nats";
  spec.x = {kLeast, kMost};
  spec.log_x = true;
  spec.y = {0, 0.75};
  spec.size = size;
  spec.legend = {{"of the viewed frame", okabe::green, Swatch::dot},
                 {"before", ink::faint, Swatch::dot},
                 {"brushed", ink::highlight, Swatch::dot}};
  Chart chart(spec);
  chart.markY(kLogTwo, {ink::threshold, 1, true}, "limit log 2");
  const int now = c.viewedFrame();
  const auto draw = [&](bool current) {
    for (const UpdatePoint& p : v.points) {
      if ((p.frame == now) != current) continue;
      const bool marked = c.state.highlighted.count(p.seed_id) > 0;
      const ImU32 color = marked    ? ink::highlight
                          : current ? okabe::green
                                    : withAlpha(ink::dim, 0.55f);
      chart.point(onAxis(p.kl), p.jsd, PointShape::square, current || marked ? 2.0f : 1.2f, color);
    }
  };
  draw(false);
  draw(true);
  bool released = false;
  if (const auto box = chart.dragged(released)) {
    chart.box(*box, ink::highlight);
    if (released) {
      o.brushed = o.brush_changed = true;
      // A rectangle that touches the end of the axis means everything beyond it, too.
      o.x_lo = box->x_lo <= kLeast * 1.05 ? 0 : box->x_lo;
      o.x_hi = box->x_hi >= kMost * 0.95 ? 1e38 : box->x_hi;
      o.y_lo = box->y_lo;
      o.y_hi = box->y_hi;
    }
  } else if (o.brushed) {
    chart.box({onAxis(o.x_lo), onAxis(o.x_hi), o.y_lo, o.y_hi}, withAlpha(ink::highlight, 0.8f));
  }
  if (!chart.hovered() || ImGui::IsMouseDown(0)) return;
  ImGui::BeginTooltip();
  ImGui::Text("KL %.3g nats, JS %.3f nats", chart.mouseX(), chart.mouseY());
  ImGui::TextDisabled("Drag a rectangle to highlight seeds");
  ImGui::EndTooltip();
}

void klHistogram(const DivergenceView& v, ImVec2 size) {
  ChartSpec spec = binsSpec("KL histogram", "Kullback-Leibler", "nats (log); thin lines: medians",
                            v.shown.kl, size);
  spec.legend = {ruleEntry(FilterRule::kl, "KL(p||q)"), {"KL(q||p)", okabe::purple, Swatch::line}};
  spec.y = {0, tallest({&v.shown.kl, &v.shown.kl_reverse})};
  Chart chart(spec);
  histogram(chart, v.shown.kl_reverse, {okabe::purple, 1.6f, false});
  histogram(chart, v.shown.kl, ruleLine(FilterRule::kl, 1.6f));
}

void jsHistogram(const DivergenceView& v, ImVec2 size) {
  ChartSpec spec =
      binsSpec("JS histogram", "Jensen-Shannon", "nats, 0 to log 2", v.shown.jsd, size);
  spec.legend = {ruleEntry(FilterRule::js)};
  spec.y = {0, tallest({&v.shown.jsd})};
  Chart chart(spec);
  histogram(chart, v.shown.jsd, ruleLine(FilterRule::js, 1.6f));
}

void affinityHistogram(const DivergenceView& v, ImVec2 size) {
  ChartSpec spec =
      binsSpec("Affinity histogram", "Affinity w", "0: disjoint, 1: agree", v.shown.affinity, size);
  spec.y = {0, tallest({&v.shown.affinity})};
  Chart chart(spec);
  histogram(chart, v.shown.affinity, ruleLine(FilterRule::js, 1.6f));
}

void sigmaRatio(const DivergenceView& v, ImVec2 size) {
  const char *first = ruleName(kRules[0]), *second = ruleName(kRules[1]);
  const std::string title = format("σ of %s / σ of %s", second, first);
  const std::string unit = format("ratio (log); below 1: %s is surer", second);
  ChartSpec spec = binsSpec("Sigma ratio", title.c_str(), unit.c_str(), v.shown.sigma_ratio, size);
  spec.y = {0, tallest({&v.shown.sigma_ratio})};
  if (v.shown.sigma_ratio.total() == 0) spec.title = title + ": one rule is switched off";
  Chart chart(spec);
  chart.markX(1, {ink::dim, 1, false}, "equal");
  histogram(chart, v.shown.sigma_ratio, {okabe::green, 1.6f, false});
}

void inlierRatios(PanelContext& c, const DivergenceView& v, ImVec2 size) {
  ChartSpec spec = binsSpec("Inlier ratios", "Inlier ratio after", "a / (a + b)",
                            v.shown.ratio[kRules[0]], size);
  spec.legend = ruleLegend();
  std::vector<const Bins*> all;
  for (const Bins& bins : v.shown.ratio) all.push_back(&bins);
  spec.y = {0, 1.25 * tallest(all)};  // the label is above the bars
  Chart chart(spec);
  for (const FilterRule rule : kRules) {
    histogram(chart, v.shown.ratio[rule], ruleLine(rule, 1.6f));
  }
  chart.markX(filterGates(c).min_ratio, {ink::threshold, 1, true}, "gate");
}

void convergence(PanelContext& c, const DivergenceView& v, ImVec2 size) {
  const double gate = filterGates(c).converged_fraction;
  ChartSpec spec;
  spec.id = "Convergence curves";
  spec.title = "Convergence, median and quartiles";
  spec.x_label = "Measurements of the seed";
  spec.y_label = "σ / R (log)";
  spec.log_y = true;
  spec.legend = ruleLegend();
  spec.size = size;
  Range r{gate, gate};
  std::size_t most = 5;
  for (const FilterRule i : kRules) {
    for (const auto* values : {&v.low[i], &v.high[i]}) {
      const Range f = finiteRange(values->data(), static_cast<int>(values->size()), true);
      if (f.lo <= f.hi) r = {std::min(r.lo, f.lo), std::max(r.hi, f.hi)};
    }
    most = std::max(most, v.steps[i].size());
  }
  spec.x = {1, static_cast<double>(most)};
  spec.y = padded(r, 0.1, true);
  Chart chart(spec);
  chart.markY(gate, {ink::threshold, 1, true}, "converged below");
  for (const FilterRule rule : kRules) {
    chart.band(v.steps[rule], v.low[rule], v.high[rule], withAlpha(ruleColor(rule), 0.14f));
    chart.line(v.steps[rule], v.median[rule], ruleLine(rule));
  }
  if (!chart.hovered()) return;
  const int n = static_cast<int>(std::lround(chart.mouseX()));
  ImGui::BeginTooltip();
  ImGui::Text("After %d measurements, %d seeds", n, c.cache<FilterStats>().seedsWith(n));
  for (const FilterRule rule : kRules) {
    const auto& m = v.median[rule];
    if (n >= 1 && n <= static_cast<int>(m.size()))
      ImGui::Text("%s  median σ / R %.4f", ruleName(rule), m[static_cast<std::size_t>(n) - 1]);
  }
  ImGui::EndTooltip();
}

void coverage(const DivergenceView& v, ImVec2 size) {
  const Calibration& k = v.calibration;
  ChartSpec spec;
  spec.id = "Calibration";
  spec.title = "Calibration";
  spec.x_label = "Share a Gaussian would have within k σ";
  spec.y_label = "Share of true values within k σ";
  spec.x = spec.y = {0, 1};
  spec.size = size;
  for (const FilterRule rule : kRules) {
    spec.legend.push_back(
        ruleEntry(rule, format("%s, median NEES %.2f", ruleName(rule), k.median_nees[rule])));
  }
  Chart chart(spec);
  chart.line({0, 1}, {0, 1}, {ink::dim, 1, true});
  for (const FilterRule rule : kRules) chart.line(k.expected, k.share[rule], ruleLine(rule));
  if (!chart.hovered()) return;
  ImGui::BeginTooltip();
  ImGui::TextUnformatted("On the diagonal σ tells the truth, below it the rule is too sure");
  ImGui::TextUnformatted("NEES is (error / σ)²; a calibrated filter has a median of 0.455");
  ImGui::EndTooltip();
}

void errors(const DivergenceView& v, ImVec2 size) {
  const Calibration& k = v.calibration;
  ChartSpec spec;
  spec.id = "Distance errors";
  spec.title = "Relative error of distance";
  spec.x_label = "|error| / distance (log)";
  spec.y_label = "Share of measurements below";
  spec.x = {1e-4, 1};
  spec.log_x = true;
  spec.y = {0, 1};
  spec.size = size;
  for (const FilterRule rule : kRules) {
    spec.legend.push_back(
        ruleEntry(rule, format("%s, median %.2f %%", ruleName(rule), 100 * k.median_error[rule])));
  }
  Chart chart(spec);
  for (const FilterRule rule : kRules) {
    const auto& sorted = k.error[rule];
    std::vector<float> x, y;
    const std::size_t step = std::max<std::size_t>(1, sorted.size() / 300);
    for (std::size_t i = 0; i < sorted.size(); i += step) {
      x.push_back(std::max(sorted[i], 1e-5f));
      y.push_back(static_cast<float>(i + 1) / static_cast<float>(sorted.size()));
    }
    chart.line(x, y, ruleLine(rule));
  }
}

}  // namespace

void divergenceCharts(PanelContext& c, const DivergenceView& v) {
  const bool truth = v.calibration.count > 0;
  const float font = ImGui::GetFontSize();
  ChartGrid cells(truth ? 9 : 7, font * 19, font * 12);
  scatter(c, v, cells.next());
  klHistogram(v, cells.next());
  jsHistogram(v, cells.next());
  affinityHistogram(v, cells.next());
  sigmaRatio(v, cells.next());
  inlierRatios(c, v, cells.next());
  convergence(c, v, cells.next());
  if (!truth) return;
  coverage(v, cells.next());
  errors(v, cells.next());
}

}  // namespace svoscope::ui
