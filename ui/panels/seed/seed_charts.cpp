// SPDX-License-Identifier: MIT
#include "ui/panels/seed/seed_charts.h"

#include <algorithm>
#include <cmath>

#include "ui/palette.h"
#include "ui/panels/seed/densities.h"
#include "ui/widgets/chart.h"
#include "ui/widgets/rule_style.h"

namespace svoscope::ui {

namespace {

// Where the convergence threshold is drawn: around the second rule of the table, if it was
// computed.
const BeliefView& beliefShown(const ByRule<BeliefView>& after) {
  const BeliefView& second = after[kRules[1]];
  return drawable(second) ? second : after[kRules[0]];
}

bool measured(const SeedUpdateView& u) {
  return (u.outcome == SearchOutcome::matched || u.outcome == SearchOutcome::tracked) &&
         std::isfinite(u.x) && std::isfinite(u.tau) && u.tau > 0;
}

void widen(Range& r, double lo, double hi) {
  if (std::isfinite(lo)) r.lo = std::min(r.lo, lo);
  if (std::isfinite(hi)) r.hi = std::max(r.hi, hi);
}

// The part of the axis that shows the belief, or all of the range.
Range shownRange(PanelContext& c, const ViewedUpdate& v, double truth) {
  const double whole = v.trace->last && v.trace->last->range > 0 ? v.trace->last->range : 1;
  Range r{1e30, -1e30};
  if (v.update && !c.state.seed.whole_range) {
    for (const FilterRule rule : kRules) {
      for (const BeliefView* b : {&v.update->before[rule], &v.update->after[rule]}) {
        if (drawable(*b)) widen(r, b->mu - 3.5 * b->sigma, b->mu + 3.5 * b->sigma);
      }
    }
    if (measured(*v.update) &&
        r.lo < r.hi) {  // a far or wide measurement must not flatten the belief
      const double reach = 2 * (r.hi - r.lo);
      widen(r, std::max(r.lo - reach, v.update->x - 2.5 * v.update->tau),
            std::min(r.hi + reach, v.update->x + 2.5 * v.update->tau));
    }
    if (truth > 0 && std::abs(truth - (r.lo + r.hi) / 2) < 2 * (r.hi - r.lo))
      widen(r, truth, truth);
  }
  if (r.lo >= r.hi) r = {0, whole};
  r = padded(r, 0.04, false);
  return r;
}

struct Scene {
  Range z, shown;  // inverse distance, and what is drawn
  bool distance = false;
  double toShown(double value) const {
    return distance ? (value > 0 ? 1 / value : INFINITY) : value;
  }
  Curve curve(double mu, double sigma) const {
    return distance ? gaussianAsDistance(mu, sigma, shown) : gaussianCurve(mu, sigma, shown);
  }
};

Scene sceneOf(PanelContext& c, const ViewedUpdate& v, double truth) {
  Scene s;
  s.z = s.shown = shownRange(c, v, truth);
  s.distance = c.state.seed.distance;
  if (!s.distance) return s;
  // 1 / z runs to infinity at z = 0: end where it stops to say anything.
  const double near_end = 1 / std::max(s.z.hi, 1e-9);
  const double far_end = s.z.lo > 0 ? 1 / s.z.lo : INFINITY;
  s.shown = {near_end, std::min(far_end, near_end * 30)};
  if (s.shown.hi <= s.shown.lo) s.shown.hi = s.shown.lo * 2;
  return s;
}

void gatesOnAxis(Chart& chart, const Scene& s, double range) {
  const ImU32 outside = IM_COL32(255, 255, 255, 12);
  const double lo = s.distance ? s.toShown(range) : 0, hi = s.distance ? INFINITY : range;
  if (lo > s.shown.lo) chart.shadeX(s.shown.lo, lo, outside);
  if (hi < s.shown.hi) chart.shadeX(hi, s.shown.hi, outside);
  chart.markX(s.distance ? lo : 0, {ink::faint, 1, true}, s.distance ? "nearest" : "infinity", 2);
  if (!s.distance) chart.markX(range, {ink::faint, 1, true}, "range R", 2);
}

}  // namespace

void densityChart(PanelContext& c, const ViewedUpdate& v, const FilterGates& gates, ImVec2 size) {
  const double truth = v.trace->last ? trueInverseDistance(c, *v.trace->last) : 0;
  const double range = v.trace->last && v.trace->last->range > 0 ? v.trace->last->range : 0;
  const Scene s = sceneOf(c, v, truth);
  ChartSpec spec;
  spec.id = "Belief density";
  spec.title = s.distance ? "Density over distance" : "Density over inverse distance";
  spec.x_label = s.distance ? "Distance, map units" : "Inverse distance, 1/map unit";
  spec.x = s.shown;
  spec.y_ticks = false;
  spec.size = size;
  spec.legend = ruleLegend();
  spec.legend.push_back({"faint: before", ink::faint, Swatch::line});
  Curve measurement, prior;
  ByRule<Curve> now, then;
  float top = 0;
  if (v.update) {
    for (const FilterRule rule : kRules) {
      const BeliefView &b = v.update->before[rule], &a = v.update->after[rule];
      if (drawable(b)) then[rule] = s.curve(b.mu, b.sigma);
      if (drawable(a)) now[rule] = s.curve(a.mu, a.sigma);
      top = std::max({top, now[rule].peak(), then[rule].peak()});
    }
    if (measured(*v.update)) measurement = s.curve(v.update->x, v.update->tau);
    top = std::max(top, std::min(measurement.peak(), top > 0 ? 2 * top : measurement.peak()));
    const BeliefView& first = v.trace->updates.front().before[kRules.front()];
    if (v.index > 0 && drawable(first)) prior = s.curve(first.mu, first.sigma);
  }
  if (!measurement.x.empty())
    spec.legend.push_back({"measurement", ink::measurement, Swatch::line});
  if (!prior.x.empty()) spec.legend.push_back({"first held", ink::prior, Swatch::dashed});
  if (truth > 0) spec.legend.push_back({"true", ink::cursor, Swatch::line});
  spec.legend.push_back({format("±R/%.0f: converged", 1 / std::max(1e-9, gates.converged_fraction)),
                         ink::threshold, Swatch::line});
  spec.y = {0, top > 0 ? 1.12 * top : 1};
  Chart chart(spec);
  if (range > 0) gatesOnAxis(chart, s, range);
  chart.area(measurement.x, measurement.y, withAlpha(ink::measurement, 0.16f));
  chart.line(measurement.x, measurement.y, {withAlpha(ink::measurement, 0.9f), 1.2f, false});
  chart.line(prior.x, prior.y, {withAlpha(ink::prior, 0.8f), 1.2f, true});
  for (const FilterRule rule : kRules) {
    chart.line(then[rule].x, then[rule].y, ruleLine(rule, 1, 0.45f));
    chart.area(now[rule].x, now[rule].y, withAlpha(ruleColor(rule), 0.10f));
    chart.line(now[rule].x, now[rule].y, ruleLine(rule, 2));
  }
  if (truth > 0) chart.markX(s.toShown(truth), {ink::cursor, 1.5f, false}, "true", 0);
  if (v.update && range > 0) {
    const BeliefView& a = beliefShown(v.update->after);
    const double half = range * gates.converged_fraction;
    if (std::isfinite(a.mu))
      chart.spanAt(s.toShown(a.mu + half), s.toShown(a.mu - half), 0.05f, ink::threshold);
  }
  if (!chart.hovered()) return;
  ImGui::BeginTooltip();
  const double x = chart.mouseX(), z = s.distance ? 1 / std::max(1e-12, x) : x;
  ImGui::Text("%.4f 1/map unit", z);
  if (z > 0) ImGui::Text("%.3f map units", 1 / z);
  ImGui::EndTooltip();
}

void ratioDensityChart(const ViewedUpdate& v, const FilterGates& gates, ImVec2 size) {
  ChartSpec spec;
  spec.id = "Inlier ratio density";
  spec.title = "Inlier ratio";
  spec.x_label = "a / (a + b)";
  spec.x = {0, 1};
  spec.y_ticks = false;
  spec.size = size;
  ByRule<Curve> now, then;
  float top = 0;
  for (const FilterRule rule : kRules) {
    if (!v.update) continue;
    const BeliefView &b = v.update->before[rule], &a = v.update->after[rule];
    if (drawable(b)) then[rule] = betaCurve(b.a, b.b);
    if (!drawable(a)) continue;
    now[rule] = betaCurve(a.a, a.b);
    top = std::max({top, now[rule].peak(), then[rule].peak()});
    spec.legend.push_back(ruleEntry(rule, format("%s Beta(%.1f, %.1f)", ruleName(rule), a.a, a.b)));
  }
  spec.y = {0, top > 0 ? 1.12 * top : 1};
  Chart chart(spec);
  chart.shadeX(0, gates.reject_ratio, withAlpha(ink::threshold, 0.15f));
  chart.markX(gates.min_ratio, {ink::threshold, 1, true}, "gate");
  chart.markX(gates.reject_ratio, {ink::threshold, 1, true}, "rejected", 1);
  for (const FilterRule rule : kRules) {
    chart.line(then[rule].x, then[rule].y, ruleLine(rule, 1, 0.45f));
    chart.area(now[rule].x, now[rule].y, withAlpha(ruleColor(rule), 0.10f));
    chart.line(now[rule].x, now[rule].y, ruleLine(rule, 2));
  }
}

}  // namespace svoscope::ui
