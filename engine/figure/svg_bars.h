// SPDX-License-Identifier: MIT
// Horizontal bars or dots with whiskers, in groups: one group for a sequence, one bar for a system.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/figure/svg.h"

namespace svoscope {

struct SvgBar {
  double value = 0;
  double low = 0, high = 0;  ///< whisker; none where equal
};

struct SvgBarGroup {
  std::string label;
  std::vector<std::optional<SvgBar>> bars;  ///< one for each series; empty: no value, drawn as "-"
};

struct SvgBarSeries {
  std::string name;
  FigureStyle style;
};

struct SvgBarChart {
  std::string title, x_label;  ///< label with unit
  std::vector<SvgBarSeries> series;
  std::vector<SvgBarGroup> groups;
  bool log = false;                 ///< draws dots: bars have no beginning on a logarithmic axis
  bool dots = false;                ///< dots on a linear axis
  std::optional<double> reference;  ///< a vertical line, always inside of the axis
  double width = 760;
};

Svg drawBars(const SvgBarChart& chart);

}  // namespace svoscope
