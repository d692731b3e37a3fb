// SPDX-License-Identifier: MIT
#include "engine/figure/chart.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "engine/figure/axis.h"

namespace svoscope {

namespace {

constexpr int kLeft = 84, kRight = 20, kTop = 40, kBottom = 62;
constexpr int kSubpixel = 4;  // bits of fraction in OpenCV's line coordinates
const cv::Scalar kInk(40, 40, 40), kGrid(228, 228, 228);

cv::Scalar bgr(ChartColor color) {
  switch (color) {
    case ChartColor::blue:
      return {178, 114, 0};
    case ChartColor::vermillion:
      return {0, 94, 213};
    case ChartColor::orange:
      return {0, 159, 230};
    case ChartColor::green:
      return {115, 158, 0};
    case ChartColor::grey:
      return {150, 150, 150};
    case ChartColor::black:
      break;
  }
  return {0, 0, 0};
}

/// `anchor`: 0 left, 0.5 centred, 1 right of x.
void text(cv::Mat& image, const std::string& s, double x, double y, double anchor,
          double scale = 0.45) {
  int baseline = 0;
  const cv::Size size = cv::getTextSize(s, cv::FONT_HERSHEY_SIMPLEX, scale, 1, &baseline);
  cv::putText(image, s, cv::Point(static_cast<int>(x - anchor * size.width), static_cast<int>(y)),
              cv::FONT_HERSHEY_SIMPLEX, scale, kInk, 1, cv::LINE_AA);
}

class Panel {
 public:
  Panel(cv::Mat canvas, const ChartPanel& p) : canvas_(canvas), p_(p) {
    x_ = axis([](const ChartSeries& s) -> const std::vector<double>& { return s.x; }, false, false);
    y_ = axis([](const ChartSeries& s) -> const std::vector<double>& { return s.y; }, p.log_y,
              p.from_zero);
  }

  void draw() {
    text(canvas_, p_.title, kLeft, 26, 0, 0.55);
    drawAxes();
    for (const ChartSeries& s : p_.series) drawSeries(s);
    drawLegend();
  }

 private:
  int right() const { return canvas_.cols - kRight; }
  int bottom() const { return canvas_.rows - kBottom; }
  double pixelX(double v) const { return kLeft + x_.part(v) * (right() - kLeft); }
  double pixelY(double v) const { return bottom() - y_.part(v) * (bottom() - kTop); }

  template <typename Values>
  Axis axis(const Values& valuesOf, bool log, bool from_zero) const {
    std::vector<double> all;
    for (const ChartSeries& s : p_.series) {
      const std::vector<double>& values = valuesOf(s);
      all.insert(all.end(), values.begin(), values.end());
    }
    return fitAxis(all, log, from_zero);
  }

  void drawAxes() {
    for (const double v : y_.ticks()) {
      const int y = static_cast<int>(std::lround(pixelY(v)));
      cv::line(canvas_, {kLeft, y}, {right(), y}, kGrid);
      text(canvas_, tickText(v), kLeft - 8, y + 5, 1);
    }
    for (const double v : x_.ticks()) {
      const int x = static_cast<int>(std::lround(pixelX(v)));
      cv::line(canvas_, {x, kTop}, {x, bottom()}, kGrid);
      text(canvas_, tickText(v), x, bottom() + 20, 0.5);
    }
    cv::rectangle(canvas_, {kLeft, kTop}, {right(), bottom()}, kInk);
    text(canvas_, p_.x_label, 0.5 * (kLeft + right()), bottom() + 46, 0.5);
    // OpenCV writes horizontally only: the label is turned.
    cv::Mat label(24, bottom() - kTop + 60, CV_8UC3, cv::Scalar::all(255)), turned;
    text(label, p_.y_label, 0.5 * label.cols, 16, 0.5);
    cv::rotate(label, turned, cv::ROTATE_90_COUNTERCLOCKWISE);
    const int top = std::max(0, (kTop + bottom()) / 2 - turned.rows / 2);
    turned.rowRange(0, std::min(turned.rows, canvas_.rows - top))
        .copyTo(canvas_(cv::Rect(4, top, turned.cols, std::min(turned.rows, canvas_.rows - top))));
  }

  void drawLine(cv::Point2d a, cv::Point2d b, const cv::Scalar& color) {
    const double one = 1 << kSubpixel;
    cv::line(canvas_, cv::Point(static_cast<int>(a.x * one), static_cast<int>(a.y * one)),
             cv::Point(static_cast<int>(b.x * one), static_cast<int>(b.y * one)), color, 2,
             cv::LINE_AA, kSubpixel);
  }

  /// Draws a to b with the dash pattern running on over the whole series.
  void drawDashed(cv::Point2d a, cv::Point2d b, const ChartSeries& s, double& walked) {
    if (s.dash <= 0) return drawLine(a, b, bgr(s.color));
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    for (double at = 0; at < length;) {
      const double left = s.dash - std::fmod(walked, s.dash);
      const double end = std::min(length, at + left);
      if (static_cast<long>(walked / s.dash) % 2 == 0)
        drawLine(a + (b - a) * (at / length), a + (b - a) * (end / length), bgr(s.color));
      walked += std::max(end - at, 1e-6);
      at = end;
    }
  }

  void drawSeries(const ChartSeries& s) {
    bool has_last = false;
    cv::Point2d last;
    double walked = 0;
    for (std::size_t i = 0; i < std::min(s.x.size(), s.y.size()); ++i) {
      const bool good = std::isfinite(s.x[i]) && std::isfinite(s.y[i]) && (!y_.log || s.y[i] > 0);
      if (good) {
        const cv::Point2d at(pixelX(s.x[i]), pixelY(s.y[i]));
        if (has_last) drawDashed(last, at, s, walked);
        last = at;
      }
      has_last = good;
    }
  }

  void drawLegend() {
    double widest = 0;
    for (const ChartSeries& s : p_.series) {
      int baseline = 0;
      widest = std::max<double>(
          widest, cv::getTextSize(s.name, cv::FONT_HERSHEY_SIMPLEX, 0.45, 1, &baseline).width);
    }
    const int width = static_cast<int>(widest) + 62,
              height = 20 * static_cast<int>(p_.series.size()) + 10;
    const cv::Point corner = emptiestCorner(width, height);
    const int x = corner.x, y = corner.y;
    cv::rectangle(canvas_, cv::Rect(x, y, width, height), cv::Scalar::all(255), cv::FILLED);
    cv::rectangle(canvas_, cv::Rect(x, y, width, height), kGrid);
    for (std::size_t i = 0; i < p_.series.size(); ++i) {
      const double row = y + 15 + 20.0 * static_cast<double>(i);
      double walked = 0;
      drawDashed({x + 8.0, row}, {x + 44.0, row}, p_.series[i], walked);
      text(canvas_, p_.series[i].name, x + 52, row + 4, 0);
    }
  }

  /// Top left of a legend where it covers the fewest points.
  cv::Point emptiestCorner(int width, int height) const {
    const int left = kLeft + 8, high = kTop + 8, far = right() - width - 8,
              low = bottom() - height - 8;
    cv::Point best;
    int fewest = std::numeric_limits<int>::max();
    for (const cv::Point corner :
         {cv::Point(far, high), cv::Point(left, high), cv::Point(far, low), cv::Point(left, low)}) {
      const cv::Rect2d box(corner.x - 6, corner.y - 6, width + 12, height + 12);
      int covered = 0;
      for (const ChartSeries& s : p_.series) {
        for (std::size_t i = 0; i < std::min(s.x.size(), s.y.size()); ++i) {
          if (!std::isfinite(s.x[i]) || !std::isfinite(s.y[i])) continue;
          covered += box.contains(cv::Point2d(pixelX(s.x[i]), pixelY(s.y[i])));
        }
      }
      if (covered < fewest) {
        fewest = covered;
        best = corner;
      }
    }
    return best;
  }

  cv::Mat canvas_;
  const ChartPanel& p_;
  Axis x_, y_;
};

}  // namespace

cv::Mat drawCharts(const std::vector<ChartPanel>& panels, int columns, int width, int height) {
  const int count = static_cast<int>(panels.size());
  columns = std::max(1, std::min(columns, count));
  const int rows = std::max(1, (count + columns - 1) / columns);
  cv::Mat image(rows * height, columns * width, CV_8UC3, cv::Scalar::all(255));
  for (int i = 0; i < count; ++i)
    Panel(image(cv::Rect(i % columns * width, i / columns * height, width, height)),
          panels[static_cast<std::size_t>(i)])
        .draw();
  return image;
}

}  // namespace svoscope
