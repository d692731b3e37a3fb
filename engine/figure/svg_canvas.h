// SPDX-License-Identifier: MIT
#pragma once

#include "engine/figure/canvas.h"
#include "engine/figure/svg.h"

namespace svoscope {

/// Attributes of a line and of a filled bar or dot in a style.
std::string svgStroke(const FigureStyle& style, double width);
std::string svgFill(const FigureStyle& style);

/// Draws into `svg`, which must outlive it.
class SvgCanvas : public Canvas {
 public:
  explicit SvgCanvas(Svg& svg) : svg_(svg) {}

  void line(FigurePoint a, FigurePoint b, const Stroke& stroke) override;
  void polyline(const std::vector<FigurePoint>& points, const Stroke& stroke) override;
  void rect(FigurePoint corner, double width, double height, const Stroke& stroke) override;
  void circle(FigurePoint centre, double radius, const Stroke& stroke) override;
  void cross(FigurePoint centre, double radius, const Stroke& stroke) override;
  void text(FigurePoint at, const std::string& text, TextAnchor anchor, TextInk ink) override;
  void turnedText(FigurePoint at, const std::string& text, TextInk ink) override;
  void beginClip(FigurePoint corner, double width, double height) override;
  void endClip() override;

 private:
  Svg& svg_;
};

}  // namespace svoscope
