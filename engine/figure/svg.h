// SPDX-License-Identifier: MIT
// Vector graphics as text. Colours that are not those of the data are classes of kSvgStyle, so that
// a figure can be read on light and on dark ground.
#pragma once

#include <string>
#include <vector>

#include "engine/figure/canvas.h"

namespace svoscope {

/// '&', '<', '>' and quotes as entities; control characters, which XML does not allow, as '?'.
std::string xmlEscaped(const std::string& text);

/// Rules of the classes used: ink, dim, faint, grid, axis, truth, ground.
extern const char* const kSvgStyle;

class Svg {
 public:
  /// `label` is read out in place of the picture.
  Svg(double width, double height, const std::string& label);

  /// `attributes` as in SVG: class="grid", stroke="#d55e00" ...
  void line(FigurePoint a, FigurePoint b, const std::string& attributes);
  /// Points nearer than 0.7 px to the one before are left out.
  void polyline(const std::vector<FigurePoint>& points, const std::string& attributes);
  void rect(FigurePoint corner, double width, double height, const std::string& attributes);
  void circle(FigurePoint centre, double radius, const std::string& attributes);
  void cross(FigurePoint centre, double radius, const std::string& attributes);
  /// `css` is a class: "ink", "dim", "title".
  void text(FigurePoint at, const std::string& text, TextAnchor anchor, const std::string& css);
  /// Reads upwards.
  void turnedText(FigurePoint at, const std::string& text, const std::string& css);
  /// What follows, up to endClip, is cut at the rectangle.
  void beginClip(FigurePoint corner, double width, double height);
  void endClip();

  /// To stand in an HTML page that has kSvgStyle.
  std::string inlined() const;
  /// A file of its own.
  std::string standalone() const;

 private:
  std::string head(bool standalone) const;
  double width_, height_;
  std::string label_, body_;
};

}  // namespace svoscope
