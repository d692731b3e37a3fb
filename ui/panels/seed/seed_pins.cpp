// SPDX-License-Identifier: MIT
// Pinned seeds, one compact row each: belief now and uncertainty over updates, on common axes.
#include <algorithm>
#include <cmath>

#include "ui/palette.h"
#include "ui/panels/seed/densities.h"
#include "ui/panels/seed/seed_charts.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/pen.h"
#include "ui/widgets/probe.h"

namespace svoscope::ui {

namespace {

struct Box {
  ImVec2 lo, hi;
  ImVec2 at(double u, double v) const {
    return {lo.x + static_cast<float>(std::clamp(u, -1.0, 2.0)) * (hi.x - lo.x),
            hi.y - static_cast<float>(std::clamp(v, -1.0, 2.0)) * (hi.y - lo.y)};
  }
};

void polyline(const Box& box, const std::vector<ImVec2>& unit, ImU32 color, bool dashed) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  for (std::size_t i = 1; i < unit.size(); ++i) {
    if (dashed && i % 6 >= 4) continue;
    pen::line(list, box.at(unit[i - 1].x, unit[i - 1].y), box.at(unit[i].x, unit[i].y), color,
              dp(1.5f));
  }
}

void densities(const Box& box, const SeedView& s, double truth) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  pen::rectFilled(list, box.lo, box.hi, ink::canvas);
  const double range = s.range > 0 ? s.range : 1;
  for (const FilterRule rule : kRules) {
    const BeliefView& b = s.belief[rule];
    if (!drawable(b)) continue;
    const Curve curve = gaussianCurve(b.mu, b.sigma, {0, range});
    const float peak = std::max(curve.peak(), 1e-12f);
    std::vector<ImVec2> unit;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      unit.push_back({static_cast<float>(curve.x[i] / range), 0.9f * curve.y[i] / peak});
    }
    polyline(box, unit, ruleColor(rule), ruleDashed(rule));
  }
  if (truth > 0 && truth < range)
    pen::line(list, box.at(truth / range, 0), box.at(truth / range, 1), ink::cursor, dp(1));
}

void convergence(const Box& box, const TraceColumns& t, double gate, std::size_t most) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  pen::rectFilled(list, box.lo, box.hi, ink::canvas);
  const auto height = [&](double ratio) {  // 3 decades: 0.001 .. 1
    return ratio > 0 ? static_cast<float>(std::clamp(1 + std::log10(ratio) / 3, 0.0, 1.0)) : 0;
  };
  pen::line(list, box.at(0, height(gate)), box.at(1, height(gate)), withAlpha(ink::threshold, 0.8f),
            dp(1));
  for (const FilterRule rule : kRules) {
    const auto& sigma = t.rule[rule].sigma_ratio;
    std::vector<ImVec2> unit;
    for (std::size_t i = 0; i < sigma.size(); ++i) {
      if (std::isfinite(sigma[i])) {
        unit.push_back(
            {static_cast<float>(i) / static_cast<float>(std::max<std::size_t>(1, most - 1)),
             height(sigma[i])});
      }
    }
    polyline(box, unit, ruleColor(rule), ruleDashed(rule));
  }
}

void row(PanelContext& c, const SeedTrace& t, const FilterGates& gates, std::size_t most) {
  const float font = ImGui::GetFontSize(), height = font * 2.2f;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float full = ImGui::GetContentRegionAvail().x, text = font * 11, gap = grid(2);
  const float width = std::max(grid(4), (full - text - 2 * gap) / 2);
  const std::string label = format("pin:%lld", static_cast<long long>(t.id));
  if (ImGui::InvisibleButton(label.c_str(), {full, height}))
    c.state.selection = {Selection::Kind::seed, t.id};
  Probe::record(label, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  tooltip("Click to select this seed");
  ImDrawList* list = ImGui::GetWindowDrawList();
  const bool selected = c.state.selection == Selection{Selection::Kind::seed, t.id};
  const std::string name = format("Seed %lld", static_cast<long long>(t.id));
  pen::text(list, {at.x, at.y + grid(0.5f)}, selected ? ink::selected : ink::text, name.c_str());
  if (!t.last) return;
  const std::string status =
      std::string(seedStatusName(t.last->status)) + ", " + counted(t.last->updates, "update");
  pen::text(list, {at.x, at.y + font + grid(0.5f)}, seedColor(*t.last), status.c_str());
  const float x = at.x + text;
  densities({{x, at.y}, {x + width, at.y + height}}, *t.last, trueInverseDistance(c, *t.last));
  convergence({{x + width + gap, at.y}, {x + 2 * width + gap, at.y + height}}, traceColumns(t),
              gates.converged_fraction, most);
}

}  // namespace

void pinnedRows(PanelContext& c, const FilterGates& gates) {
  heading("Pinned: density over 0 … R, and σ / R from 1 to 0.001 over updates");
  std::size_t most = 2;
  for (const std::int64_t id : c.state.seed.pinned) {
    if (const SeedTrace* t = c.cache<SeedTraces>().find(id))
      most = std::max(most, t->updates.size());
  }
  for (const std::int64_t id : c.state.seed.pinned) {
    if (const SeedTrace* t = c.cache<SeedTraces>().find(id)) row(c, *t, gates, most);
  }
}

}  // namespace svoscope::ui
