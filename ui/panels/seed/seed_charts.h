// SPDX-License-Identifier: MIT
// Pictures of what a seed believes, before and after an update, and of how it came there.
#pragma once

#include "ui/model/seed_trace.h"
#include "ui/panels/panel_context.h"

namespace svoscope::ui {

/// The beliefs of all rules before and after, the measurement, prior, range, truth and convergence
/// threshold.
void densityChart(PanelContext& c, const ViewedUpdate& v, const FilterGates& gates, ImVec2 size);
/// Beta densities of the inlier ratio of all rules, with the gates.
void ratioDensityChart(const ViewedUpdate& v, const FilterGates& gates, ImVec2 size);

/// Columns of a trace: one entry per update.
struct TraceColumns {
  std::vector<float> step;           ///< 1, 2, ...
  std::vector<float> x, x_lo, x_hi;  ///< measurement -/+ tau; NaN if none
  struct PerRule {
    std::vector<float> mu, lo, hi, sigma_ratio, inlier_ratio;
  };
  ByRule<PerRule> rule;
  std::vector<float> failed;  ///< steps without a match
};
TraceColumns traceColumns(const SeedTrace& trace);

/// The three histories; a click looks at that update.
void beliefHistory(PanelContext& c, const ViewedUpdate& v, const TraceColumns& columns,
                   ImVec2 size);
void sigmaHistory(PanelContext& c, const ViewedUpdate& v, const TraceColumns& columns,
                  const FilterGates& gates, ImVec2 size);
void ratioHistory(PanelContext& c, const ViewedUpdate& v, const TraceColumns& columns,
                  const FilterGates& gates, ImVec2 size);

/// Pinned seeds, one compact row each.
void pinnedRows(PanelContext& c, const FilterGates& gates);

/// One row of numbers: text for every rule, before and after an update.
struct SeedFact {
  std::string name;
  ByRule<std::string> text;
};
std::vector<SeedFact> seedFacts(const SeedUpdateView& update, double true_inv_distance);

std::string traceCsv(const SeedTrace& trace);

}  // namespace svoscope::ui
