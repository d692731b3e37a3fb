// SPDX-License-Identifier: MIT
#include "engine/figure/svg_canvas.h"

#include <fmt/format.h>

namespace svoscope {

namespace {

std::string attributesOf(const Stroke& stroke) {
  switch (stroke.ink) {
    case LineInk::grid:
      return "class=\"grid\"";
    case LineInk::axis:
      return "class=\"axis\"";
    case LineInk::mark:
      return fmt::format("class=\"loss\" stroke-width=\"{:.1f}\"", stroke.width);
    case LineInk::series:
      break;
  }
  return svgStroke(stroke.style, stroke.width);
}

const char* classOf(TextInk ink) {
  switch (ink) {
    case TextInk::dim:
      return "dim";
    case TextInk::title:
      return "title";
    case TextInk::ink:
      break;
  }
  return "ink";
}

}  // namespace

std::string svgStroke(const FigureStyle& style, double width) {
  const std::string dashes =
      style.dash.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", style.dash);
  const std::string ink =
      style.color.empty() ? "class=\"truth\"" : fmt::format("stroke=\"{}\"", style.color);
  return fmt::format("{} stroke-width=\"{:.1f}\" stroke-linejoin=\"round\"{}", ink, width, dashes);
}

std::string svgFill(const FigureStyle& style) {
  const std::string ink =
      style.color.empty() ? "class=\"ink\"" : fmt::format("fill=\"{}\"", style.color);
  return style.opacity < 1 ? ink + fmt::format(" fill-opacity=\"{:g}\"", style.opacity) : ink;
}

void SvgCanvas::line(FigurePoint a, FigurePoint b, const Stroke& stroke) {
  svg_.line(a, b, attributesOf(stroke));
}

void SvgCanvas::polyline(const std::vector<FigurePoint>& points, const Stroke& stroke) {
  svg_.polyline(points, attributesOf(stroke));
}

void SvgCanvas::rect(FigurePoint corner, double width, double height, const Stroke& stroke) {
  svg_.rect(corner, width, height, attributesOf(stroke));
}

void SvgCanvas::circle(FigurePoint centre, double radius, const Stroke& stroke) {
  svg_.circle(centre, radius, "fill=\"none\" " + attributesOf(stroke));
}

void SvgCanvas::cross(FigurePoint centre, double radius, const Stroke& stroke) {
  svg_.cross(centre, radius, attributesOf(stroke));
}

void SvgCanvas::text(FigurePoint at, const std::string& text, TextAnchor anchor, TextInk ink) {
  svg_.text(at, text, anchor, classOf(ink));
}

void SvgCanvas::turnedText(FigurePoint at, const std::string& text, TextInk ink) {
  svg_.turnedText(at, text, classOf(ink));
}

void SvgCanvas::beginClip(FigurePoint corner, double width, double height) {
  svg_.beginClip(corner, width, height);
}

void SvgCanvas::endClip() { svg_.endClip(); }

}  // namespace svoscope
