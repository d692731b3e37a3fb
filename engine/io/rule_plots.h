// SPDX-License-Identifier: MIT
// What the figures of the filter lab and of the depth study share: a series for each rule.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/figure/line_plot.h"

namespace svoscope {

/// A plot with a series for each row (with a member `rule`), four of which fill an image: the same
/// rule has the same look in every plot. `fill(row, series)` adds the points.
template <typename Row, typename Fill>
LinePlot rulePlot(const std::vector<Row>& rows, const std::string& title,
                  const std::string& x_label, const std::string& y_label, const Fill& fill) {
  LinePlot plot;
  plot.title = title;
  plot.x_label = x_label;
  plot.y_label = y_label;
  plot.width = 480;
  plot.height = 294;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    LineSeries series;
    series.name = rows[i].rule;
    series.style = numberedStyle(i);
    fill(rows[i], series);
    plot.series.push_back(std::move(series));
  }
  return plot;
}

}  // namespace svoscope
