// SPDX-License-Identifier: MIT
#include "engine/figure/raster_canvas.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <opencv2/imgproc.hpp>
#include <sstream>

namespace svoscope {

namespace {

constexpr int kSubpixel = 4;  // bits of fraction in OpenCV's coordinates
constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;

/// "#rrggbb" as OpenCV orders it; black if it is something else.
cv::Scalar bgr(const std::string& color) {
  if (color.size() != 7 || color[0] != '#') return {0, 0, 0};
  const long value = std::strtol(color.c_str() + 1, nullptr, 16);
  return cv::Scalar(value & 255, value >> 8 & 255, value >> 16 & 255);
}

cv::Scalar colorOf(const Stroke& stroke) {
  switch (stroke.ink) {
    case LineInk::grid:
      return bgr("#e3e6ea");
    case LineInk::axis:
      return bgr("#8c959f");
    case LineInk::mark:
      return bgr("#1f2328");
    case LineInk::series:
      break;
  }
  return bgr(stroke.style.color.empty() ? "#6e7781" : stroke.style.color);
}

cv::Scalar colorOf(TextInk ink) { return bgr(ink == TextInk::dim ? "#57606a" : "#1f2328"); }

/// Size of OpenCV's letters, about that of the SVG's.
double fontScale(TextInk ink, double scale) { return (ink == TextInk::title ? 0.4 : 0.34) * scale; }

/// Lengths of dash and gap in turn, an even number of them; empty: solid.
std::vector<double> dashesOf(const Stroke& stroke, double scale) {
  std::vector<double> lengths;
  if (stroke.ink != LineInk::series) return lengths;
  std::istringstream in(stroke.style.dash);
  for (double length = 0; in >> length;)
    if (length > 0) lengths.push_back(length * scale);
  const std::size_t count = lengths.size();
  if (count % 2 == 1) lengths.insert(lengths.end(), lengths.begin(), lengths.begin() + count);
  return lengths;
}

cv::Point fixedPoint(cv::Point2d p) {
  constexpr double kOne = 1 << kSubpixel;
  return {static_cast<int>(std::lround(p.x * kOne)), static_cast<int>(std::lround(p.y * kOne))};
}

int thicknessOf(double width, double scale) {
  return std::max(1, static_cast<int>(std::lround(width * scale)));
}

}  // namespace

RasterCanvas::RasterCanvas(const cv::Mat& image, double scale)
    : image_(image), target_(image), scale_(scale) {}

cv::Point2d RasterCanvas::pixel(FigurePoint p) const {
  return {p.x * scale_ - origin_.x, p.y * scale_ - origin_.y};
}

void RasterCanvas::segment(cv::Point2d a, cv::Point2d b, const Stroke& stroke) {
  cv::line(target_, fixedPoint(a), fixedPoint(b), colorOf(stroke),
           thicknessOf(stroke.width, scale_), cv::LINE_AA, kSubpixel);
}

void RasterCanvas::line(FigurePoint a, FigurePoint b, const Stroke& stroke) {
  if (stroke.ink == LineInk::series || stroke.ink == LineInk::mark) return polyline({a, b}, stroke);
  const cv::Point2d from = pixel(a), to = pixel(b);  // on whole pixels: sharp and thin
  cv::line(target_, cv::Point(from), cv::Point(to), colorOf(stroke));
}

void RasterCanvas::polyline(const std::vector<FigurePoint>& points, const Stroke& stroke) {
  const std::vector<double> dashes = dashesOf(stroke, scale_);
  std::size_t dash = 0;  // even: ink, odd: gap; the pattern runs on over corners
  double left = dashes.empty() ? 0 : dashes[0];
  for (std::size_t i = 1; i < points.size(); ++i) {
    const cv::Point2d a = pixel(points[i - 1]), b = pixel(points[i]);
    if (dashes.empty()) {
      segment(a, b, stroke);
      continue;
    }
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    for (double at = 0; at < length;) {
      const double end = std::min(length, at + left);
      if (dash % 2 == 0) segment(a + (b - a) * (at / length), a + (b - a) * (end / length), stroke);
      left -= end - at;
      if (end < length) {
        dash = (dash + 1) % dashes.size();
        left = dashes[dash];
      }
      at = end;
    }
  }
}

void RasterCanvas::rect(FigurePoint corner, double width, double height, const Stroke& stroke) {
  cv::rectangle(target_, cv::Point(pixel(corner)),
                cv::Point(pixel({corner.x + width, corner.y + height})), colorOf(stroke));
}

void RasterCanvas::circle(FigurePoint centre, double radius, const Stroke& stroke) {
  cv::circle(target_, fixedPoint(pixel(centre)), fixedPoint({radius * scale_, 0}).x,
             colorOf(stroke), thicknessOf(stroke.width, scale_), cv::LINE_AA, kSubpixel);
}

void RasterCanvas::cross(FigurePoint c, double r, const Stroke& stroke) {
  segment(pixel({c.x - r, c.y - r}), pixel({c.x + r, c.y + r}), stroke);
  segment(pixel({c.x - r, c.y + r}), pixel({c.x + r, c.y - r}), stroke);
}

void RasterCanvas::text(FigurePoint at, const std::string& text, TextAnchor anchor, TextInk ink) {
  const double scale = fontScale(ink, scale_);
  int baseline = 0;
  const int width = cv::getTextSize(text, kFont, scale, 1, &baseline).width;
  cv::Point2d start = pixel(at);
  start.x -= anchor == TextAnchor::end ? width : anchor == TextAnchor::middle ? 0.5 * width : 0;
  cv::putText(target_, text, cv::Point(start), kFont, scale, colorOf(ink), 1, cv::LINE_AA);
}

void RasterCanvas::turnedText(FigurePoint at, const std::string& text, TextInk ink) {
  // OpenCV writes horizontally only: the text is written on a strip, which is turned.
  const double scale = fontScale(ink, scale_);
  int below = 0;
  const cv::Size size = cv::getTextSize(text, kFont, scale, 1, &below);
  cv::Mat strip(size.height + below + 2, size.width, CV_8UC3, cv::Scalar::all(255)), turned;
  cv::putText(strip, text, {0, size.height + 1}, kFont, scale, colorOf(ink), 1, cv::LINE_AA);
  cv::rotate(strip, turned, cv::ROTATE_90_COUNTERCLOCKWISE);
  const cv::Point base(pixel(at));
  const cv::Point corner(base.x - size.height - 1, base.y - turned.rows / 2);
  const cv::Rect place = cv::Rect(corner, turned.size()) & cv::Rect({0, 0}, target_.size());
  if (place.empty()) return;
  turned(place - corner).copyTo(target_(place));
}

void RasterCanvas::beginClip(FigurePoint corner, double width, double height) {
  const cv::Point a(static_cast<int>(std::floor(corner.x * scale_)),
                    static_cast<int>(std::floor(corner.y * scale_)));
  const cv::Point b(static_cast<int>(std::ceil((corner.x + width) * scale_)) + 1,
                    static_cast<int>(std::ceil((corner.y + height) * scale_)) + 1);
  const cv::Rect clip = cv::Rect(a, b) & cv::Rect({0, 0}, image_.size());
  target_ = image_(clip);
  origin_ = clip.tl();
}

void RasterCanvas::endClip() {
  target_ = image_;
  origin_ = {};
}

}  // namespace svoscope
