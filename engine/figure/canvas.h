// SPDX-License-Identifier: MIT
// What a figure is drawn on: as vector graphics (svg_canvas.h) or as an image (raster_canvas.h).
#pragma once

#include <string>
#include <vector>

#include "engine/figure/style.h"

namespace svoscope {

struct FigurePoint {
  double x = 0, y = 0;  ///< px, y down
};

enum class TextAnchor { start, middle, end };

/// Inks of the page; `series` is drawn in a style of its own.
enum class LineInk { grid, axis, mark, series };
enum class TextInk { ink, dim, title };

struct Stroke {
  LineInk ink = LineInk::series;
  double width = 1;   ///< px; grid and axis have the thinnest line there is
  FigureStyle style;  ///< of a series
};

/// Lengths in px of the figure; a raster canvas may have several pixels to one of them.
class Canvas {
 public:
  virtual ~Canvas() = default;

  virtual void line(FigurePoint a, FigurePoint b, const Stroke& stroke) = 0;
  virtual void polyline(const std::vector<FigurePoint>& points, const Stroke& stroke) = 0;
  /// Outlines.
  virtual void rect(FigurePoint corner, double width, double height, const Stroke& stroke) = 0;
  virtual void circle(FigurePoint centre, double radius, const Stroke& stroke) = 0;
  /// Two diagonals.
  virtual void cross(FigurePoint centre, double radius, const Stroke& stroke) = 0;
  /// `at` is on the base line.
  virtual void text(FigurePoint at, const std::string& text, TextAnchor anchor, TextInk ink) = 0;
  /// Reads upwards, centred.
  virtual void turnedText(FigurePoint at, const std::string& text, TextInk ink) = 0;
  /// What follows, up to endClip, is cut at the rectangle.
  virtual void beginClip(FigurePoint corner, double width, double height) = 0;
  virtual void endClip() = 0;
};

}  // namespace svoscope
