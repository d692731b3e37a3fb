// SPDX-License-Identifier: MIT
// What the figures of the filter lab and of the depth study share: a series for each rule.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/figure/line_plot.h"
#include "engine/study/rule_variants.h"

namespace svoscope {

/// A plot with a series for each row (its member `rule` names a RuleVariant), four of which fill an
/// image: a rule has its look of the table, terms of a rule are thinner. `fill(row, series)` adds
/// the points.
template <typename Row, typename Fill>
LinePlot rulePlot(const std::vector<Row>& rows, const std::string& title,
                  const std::string& x_label, const std::string& y_label, const Fill& fill) {
  LinePlot plot;
  plot.title = title;
  plot.x_label = x_label;
  plot.y_label = y_label;
  plot.width = 480;
  plot.height = 294;
  for (const Row& row : rows) {
    LineSeries series;
    series.name = row.rule;
    if (const RuleVariant* variant = findRuleVariant(series.name)) {
      series.style = styleOf(variant->look);
      series.width = variant->whole ? 2 : 1.4;
    }
    fill(row, series);
    plot.series.push_back(std::move(series));
  }
  return plot;
}

}  // namespace svoscope
