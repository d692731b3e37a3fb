// SPDX-License-Identifier: MIT
// How the rules of the depth filter look in charts: colour and dash of the rule table.
#pragma once

#include <vector>

#include "ui/palette.h"
#include "ui/widgets/chart.h"

namespace svoscope::ui {

inline LineStyle ruleLine(FilterRule rule, float width = 1.8f, float alpha = 1) {
  return {withAlpha(ruleColor(rule), alpha), width, ruleDashed(rule)};
}

/// Entry of a legend: `text`, or the rule's name.
inline ChartLegend ruleEntry(FilterRule rule, const std::string& text = {}) {
  return {text.empty() ? ruleName(rule) : text, ruleColor(rule),
          ruleDashed(rule) ? Swatch::dashed : Swatch::line};
}

/// One entry per rule.
inline std::vector<ChartLegend> ruleLegend() {
  std::vector<ChartLegend> legend;
  for (const FilterRule rule : kRules) legend.push_back(ruleEntry(rule));
  return legend;
}

}  // namespace svoscope::ui
