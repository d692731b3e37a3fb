// SPDX-License-Identifier: MIT
// Line plots: curves over time, paths in a plane. One layout for SVG files and for images.
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "engine/figure/canvas.h"
#include "engine/figure/svg.h"

namespace svoscope {

struct LineSeries {
  std::string name;  ///< in the legend; empty: not there
  FigureStyle style;
  std::vector<double> x, y;  ///< points that are not finite interrupt the line
  double width = 1.6;        ///< px
};

struct LinePlot {
  std::string title, x_label, y_label;  ///< labels with unit
  std::vector<LineSeries> series;
  std::vector<FigurePoint> losses;   ///< marked by a cross, in units of the axes
  double width = 640, height = 300;  ///< px; rows of the legend are added to the height
  bool equal_axes = false;           ///< a metre is as long in x as in y
  bool log_y = false;                ///< points with y <= 0 interrupt the line
  bool from_zero = true;             ///< the y axis starts at zero, unless log_y or equal_axes
};

/// Height with the legend, px.
double heightOf(const LinePlot& plot);

/// Draws title, axes, series and legend into width x heightOf() px.
void draw(const LinePlot& plot, Canvas& canvas);

Svg drawSvg(const LinePlot& plot);

/// Plots of one width in rows of `columns`, all as high as the highest; `scale` pixels to a px.
/// CV_8UC3, white background.
cv::Mat drawRaster(const std::vector<LinePlot>& plots, int columns, double scale = 4.0 / 3);

}  // namespace svoscope
