// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "ui/palette.h"
#include "ui/panels/seed/densities.h"
#include "ui/panels/seed/seed_charts.h"
#include "ui/theme.h"
#include "ui/widgets/chart.h"
#include "ui/widgets/probe.h"
#include "ui/widgets/rule_style.h"

namespace svoscope::ui {

namespace {

ChartSpec historySpec(const char* id, const char* title, const TraceColumns& t, ImVec2 size) {
  ChartSpec spec;
  spec.id = id;
  spec.title = title;
  // Most happens in the first few updates: a long history is spread by decades.
  spec.log_x = t.step.size() > 40;
  spec.x_label = spec.log_x ? "Update (log)" : "Update";
  spec.x = {spec.log_x ? 0.9 : 0.5,
            std::max(2.0, static_cast<double>(t.step.size())) * (spec.log_x ? 1.05 : 1) + 0.5};
  spec.size = size;
  spec.legend = ruleLegend();
  return spec;
}

// Cursor at the update looked at, read-out under the mouse, and a click that goes there.
void stepping(PanelContext& c, Chart& chart, const ViewedUpdate& v) {
  if (v.index >= 0) chart.markX(v.index + 1, {withAlpha(ink::cursor, 0.7f), 1, false});
  if (!chart.hovered() || v.trace->updates.empty()) return;
  const int count = static_cast<int>(v.trace->updates.size());
  const int i = std::clamp(static_cast<int>(std::lround(chart.mouseX())) - 1, 0, count - 1);
  const SeedUpdateView& u = v.trace->updates[static_cast<std::size_t>(i)];
  ImGui::BeginTooltip();
  ImGui::Text("Update %d, frame %d, %s", i + 1, u.frame_index, searchOutcomeName(u.outcome));
  if (u.tau > 0) ImGui::Text("x %.4f ± %.4f", u.x, u.tau);
  for (const FilterRule rule : kRules) {
    const BeliefView& b = u.after[rule];
    ImGui::Text("%s  μ %.4f  σ %.5f  ratio %.2f", ruleName(rule), b.mu, b.sigma, inlierRatio(b));
  }
  ImGui::TextDisabled("Click to look at it");
  ImGui::EndTooltip();
  if (chart.clicked()) viewUpdate(c, *v.trace, i);
}

void rangeOf(Range& r, const std::vector<float>& values) {
  const Range f = finiteRange(values.data(), static_cast<int>(values.size()), false);
  if (f.lo > f.hi) return;
  r = {std::min(r.lo, f.lo), std::max(r.hi, f.hi)};
}

}  // namespace

TraceColumns traceColumns(const SeedTrace& trace) {
  TraceColumns t;
  const float range = trace.last && trace.last->range > 0 ? trace.last->range : NAN;
  for (std::size_t i = 0; i < trace.updates.size(); ++i) {
    const SeedUpdateView& u = trace.updates[i];
    const auto step = static_cast<float>(i + 1);
    const bool has =
        (u.outcome == SearchOutcome::matched || u.outcome == SearchOutcome::tracked) && u.tau > 0;
    t.step.push_back(step);
    t.x.push_back(has ? u.x : NAN);
    t.x_lo.push_back(has ? u.x - u.tau : NAN);
    t.x_hi.push_back(has ? u.x + u.tau : NAN);
    if (!has) t.failed.push_back(step);
    for (const FilterRule rule : kRules) {
      TraceColumns::PerRule& r = t.rule[rule];
      const BeliefView& b = u.after[rule];
      const bool ok = drawable(b);
      r.mu.push_back(ok ? b.mu : NAN);
      r.lo.push_back(ok ? b.mu - b.sigma : NAN);
      r.hi.push_back(ok ? b.mu + b.sigma : NAN);
      r.sigma_ratio.push_back(ok ? b.sigma / range : NAN);
      r.inlier_ratio.push_back(ok ? static_cast<float>(inlierRatio(b)) : NAN);
    }
  }
  return t;
}

void beliefHistory(PanelContext& c, const ViewedUpdate& v, const TraceColumns& t, ImVec2 size) {
  ChartSpec spec = historySpec("Belief history", "Belief μ ± σ", t, size);
  spec.y_label = "Inverse distance, 1/map unit";
  spec.legend.push_back({"measurement x ± τ", ink::measurement, Swatch::dot});
  const double truth = v.trace->last ? trueInverseDistance(c, *v.trace->last) : 0;
  Range r{1e30, -1e30};
  for (const auto& rule : t.rule) {
    rangeOf(r, rule.lo);
    rangeOf(r, rule.hi);
  }
  Range with = r;
  rangeOf(with, t.x);
  if (r.lo <= r.hi) {  // an outlier measurement must not flatten the rest
    const double reach = std::max(r.span(), 1e-6);
    r = {std::max(with.lo, r.lo - reach), std::min(with.hi, r.hi + reach)};
    if (truth > r.lo - reach && truth < r.hi + reach)
      r = {std::min(r.lo, truth), std::max(r.hi, truth)};
  }
  spec.y = padded(r, 0.08, false);
  if (truth > 0) spec.legend.push_back({"true", ink::cursor, Swatch::line});
  if (!t.failed.empty()) spec.legend.push_back({"no measurement", ink::threshold, Swatch::cross});
  Chart chart(spec);
  if (truth > 0) chart.markY(truth, {ink::cursor, 1.3f, false});
  for (const FilterRule rule : kRules) {
    const TraceColumns::PerRule& p = t.rule[rule];
    chart.band(t.step, p.lo, p.hi, withAlpha(ruleColor(rule), 0.16f));
    chart.line(t.step, p.mu, ruleLine(rule));
  }
  const bool bars = t.step.size() < 150;
  for (std::size_t i = 0; i < t.x.size(); ++i) {
    if (bars) chart.errorBar(t.step[i], t.x_lo[i], t.x_hi[i], withAlpha(ink::measurement, 0.65f));
    chart.point(t.step[i], t.x[i], PointShape::circle, bars ? 2.5f : 1.5f, ink::measurement);
  }
  for (const float step : t.failed)
    chart.point(step, spec.y.lo + 0.05 * spec.y.span(), PointShape::cross, 3, ink::threshold);
  stepping(c, chart, v);
}

void sigmaHistory(PanelContext& c, const ViewedUpdate& v, const TraceColumns& t,
                  const FilterGates& gates, ImVec2 size) {
  ChartSpec spec = historySpec("Sigma history", "Uncertainty σ / R", t, size);
  spec.log_y = true;
  Range r{gates.converged_fraction, gates.converged_fraction};
  for (const auto& rule : t.rule) {
    const Range f =
        finiteRange(rule.sigma_ratio.data(), static_cast<int>(rule.sigma_ratio.size()), true);
    if (f.lo <= f.hi) r = {std::min(r.lo, f.lo), std::max(r.hi, f.hi)};
  }
  spec.y = padded(r, 0.1, true);
  Chart chart(spec);
  for (const FilterRule rule : kRules) {
    chart.line(t.step, t.rule[rule].sigma_ratio, ruleLine(rule));
  }
  chart.markY(gates.converged_fraction, {ink::threshold, 1, true}, "converged below");
  stepping(c, chart, v);
}

void ratioHistory(PanelContext& c, const ViewedUpdate& v, const TraceColumns& t,
                  const FilterGates& gates, ImVec2 size) {
  ChartSpec spec = historySpec("Inlier ratio history", "Inlier ratio a/(a+b)", t, size);
  spec.y = {0, 1};
  Chart chart(spec);
  for (const FilterRule rule : kRules) {
    chart.line(t.step, t.rule[rule].inlier_ratio, ruleLine(rule));
  }
  chart.markY(gates.min_ratio, {ink::threshold, 1, true}, "gate");
  chart.markY(gates.reject_ratio, {ink::threshold, 1, true}, "rejected below");
  stepping(c, chart, v);
}

std::string traceCsv(const SeedTrace& trace) {
  std::string text = "seed,update,frame,outcome,x,tau,score";
  for (const RuleInfo& rule : kRuleTable) {
    for (const char* when : {"_before", ""}) {
      for (const char* field : {"mu", "sigma", "a", "b"})
        text += format(",%s_%s%s", rule.id, field, when);
    }
  }
  text += ",kl_belief_measurement,kl_measurement_belief,jsd,affinity\n";
  const auto belief = [&](const BeliefView& b) {
    text += format(",%.9g,%.9g,%.9g,%.9g", b.mu, b.sigma, b.a, b.b);
  };
  for (std::size_t i = 0; i < trace.updates.size(); ++i) {
    const SeedUpdateView& u = trace.updates[i];
    text += format("%lld,%d,%d,%s,%.9g,%.9g,%.6g", static_cast<long long>(u.seed_id),
                   static_cast<int>(i + 1), u.frame_index, searchOutcomeName(u.outcome), u.x, u.tau,
                   u.score);
    for (const FilterRule rule : kRules) {
      belief(u.before[rule]);
      belief(u.after[rule]);
    }
    text += format(",%.9g,%.9g,%.9g,%.9g\n", u.kl_belief_measurement, u.kl_measurement_belief,
                   u.jsd, u.affinity);
  }
  return text;
}

}  // namespace svoscope::ui
