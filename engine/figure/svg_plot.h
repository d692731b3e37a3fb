// SPDX-License-Identifier: MIT
// Line plots as vector graphics: curves over time, paths in a plane.
#pragma once

#include <string>
#include <vector>

#include "engine/figure/svg.h"

namespace svoscope {

/// How a system is drawn, everywhere. Colour is never the only cue.
struct SvgStyle {
  std::string color;   ///< "#56b4e9"; empty: that of the ground truth
  std::string dash;    ///< as in SVG, "6 3"; empty: solid
  double opacity = 1;  ///< of bars and dots

  std::string stroke(double width) const;  ///< attributes of a line
  std::string fill() const;                ///< attributes of a bar or dot
};

struct SvgCurve {
  std::string name;  ///< in the legend; empty: not there
  SvgStyle style;
  std::vector<double> x, y;  ///< points that are not finite interrupt the line
  double width = 1.6;        ///< px
};

struct SvgPlot {
  std::string title, x_label, y_label;  ///< labels with unit
  std::vector<SvgCurve> curves;
  std::vector<SvgPoint> losses;  ///< marked by a cross, in units of the axes
  double width = 640, height = 300;
  bool equal_axes = false;  ///< a metre is as long in x as in y
  bool log_y = false;
  bool from_zero = true;  ///< the y axis starts at zero, unless log_y or equal_axes
};

Svg drawPlot(const SvgPlot& plot);

}  // namespace svoscope
