// SPDX-License-Identifier: MIT
#include "engine/figure/line_plot.h"

#include <algorithm>
#include <cmath>

#include "engine/figure/axis.h"
#include "engine/figure/legend.h"
#include "engine/figure/raster_canvas.h"
#include "engine/figure/svg_canvas.h"

namespace svoscope {

namespace {

constexpr double kLeft = 56, kRight = 12, kTop = 26, kBottom = 40;

int steps(double px, double each) { return std::max(2, static_cast<int>(px / each)); }

LegendRows legendOf(const LinePlot& plot) { return {kLeft, plot.width, 40}; }

/// Widens both axes about their middle to one scale for `width` x `height` px.
void equalise(Axis& x, Axis& y, double width, double height) {
  const double unit = std::max((x.high - x.low) / width, (y.high - y.low) / height);
  const auto widen = [unit](Axis& axis, double px) {
    const double middle = 0.5 * (axis.low + axis.high);
    axis.low = middle - 0.5 * unit * px;
    axis.high = middle + 0.5 * unit * px;
  };
  widen(x, width);
  widen(y, height);
  x.step = niceStep(x.high - x.low, steps(width, 70));
  y.step = niceStep(y.high - y.low, steps(height, 45));
}

class Painter {
 public:
  Painter(const LinePlot& plot, Canvas& canvas)
      : p_(plot), canvas_(canvas), right_(plot.width - kRight), bottom_(plot.height - kBottom) {
    std::vector<double> xs, ys;
    for (const LineSeries& s : plot.series) {
      xs.insert(xs.end(), s.x.begin(), s.x.end());
      ys.insert(ys.end(), s.y.begin(), s.y.end());
    }
    const double width = right_ - kLeft, height = bottom_ - kTop;
    x_ = fitAxis(xs, false, false, AxisFit::tight, steps(width, 70));
    y_ = fitAxis(ys, plot.log_y, plot.from_zero && !plot.equal_axes,
                 plot.equal_axes ? AxisFit::tight : AxisFit::round, steps(height, 34));
    if (plot.equal_axes) equalise(x_, y_, width, height);
  }

  void draw() {
    canvas_.text({kLeft, 15}, p_.title, TextAnchor::start, TextInk::title);
    drawAxes();
    canvas_.beginClip({kLeft, kTop}, right_ - kLeft, bottom_ - kTop);
    for (const LineSeries& s : p_.series) drawSeries(s);
    for (const FigurePoint& loss : p_.losses)
      canvas_.cross(at(loss.x, loss.y), 3.5, {LineInk::mark, 1.4, {}});
    canvas_.endClip();
    drawLegend();
  }

 private:
  FigurePoint at(double x, double y) const {
    return {kLeft + x_.part(x) * (right_ - kLeft), bottom_ - y_.part(y) * (bottom_ - kTop)};
  }

  void drawAxes() {
    const Stroke grid{LineInk::grid, 1, {}};
    for (const double v : y_.ticks()) {
      const double y = at(x_.low, v).y;
      canvas_.line({kLeft, y}, {right_, y}, grid);
      canvas_.text({kLeft - 5, y + 4}, tickText(v), TextAnchor::end, TextInk::dim);
    }
    for (const double v : x_.ticks()) {
      const double x = at(v, y_.low).x;
      canvas_.line({x, kTop}, {x, bottom_}, grid);
      canvas_.text({x, bottom_ + 15}, tickText(v), TextAnchor::middle, TextInk::dim);
    }
    canvas_.rect({kLeft, kTop}, right_ - kLeft, bottom_ - kTop, {LineInk::axis, 1, {}});
    canvas_.text({0.5 * (kLeft + right_), bottom_ + 32}, p_.x_label, TextAnchor::middle,
                 TextInk::dim);
    canvas_.turnedText({12, 0.5 * (kTop + bottom_)}, p_.y_label, TextInk::dim);
  }

  void drawSeries(const LineSeries& s) {
    const Stroke stroke{LineInk::series, s.width, s.style};
    std::vector<FigurePoint> piece;
    const auto flush = [&] {
      // A pose between two losses would vanish as a line without length.
      if (piece.size() == 1) canvas_.circle(piece[0], 0.6 * s.width, stroke);
      if (piece.size() > 1) canvas_.polyline(piece, stroke);
      piece.clear();
    };
    for (std::size_t i = 0; i < std::min(s.x.size(), s.y.size()); ++i) {
      if (std::isfinite(s.x[i]) && std::isfinite(s.y[i]) && (!p_.log_y || s.y[i] > 0)) {
        piece.push_back(at(s.x[i], s.y[i]));
      } else {
        flush();
      }
    }
    flush();
  }

  void drawLegend() {
    LegendRows rows = legendOf(p_);
    for (const LineSeries& s : p_.series) {
      if (s.name.empty()) continue;
      const FigurePoint entry = rows.place(s.name);
      const double x = entry.x, y = p_.height + 4 + entry.y;
      canvas_.line({x, y}, {x + 32, y}, {LineInk::series, 2, s.style});
      canvas_.text({x + 38, y + 4}, s.name, TextAnchor::start, TextInk::ink);
    }
  }

  const LinePlot& p_;
  Canvas& canvas_;
  double right_, bottom_;
  Axis x_, y_;
};

}  // namespace

double heightOf(const LinePlot& plot) {
  LegendRows rows = legendOf(plot);
  for (const LineSeries& s : plot.series)
    if (!s.name.empty()) rows.place(s.name);
  return plot.height + rows.height();
}

void draw(const LinePlot& plot, Canvas& canvas) { Painter(plot, canvas).draw(); }

Svg drawSvg(const LinePlot& plot) {
  Svg svg(plot.width, heightOf(plot), plot.title + ": " + plot.y_label + " over " + plot.x_label);
  SvgCanvas canvas(svg);
  draw(plot, canvas);
  return svg;
}

cv::Mat drawRaster(const std::vector<LinePlot>& plots, int columns, double scale) {
  const int count = static_cast<int>(plots.size());
  columns = std::max(1, std::min(columns, count));
  const int rows = std::max(1, (count + columns - 1) / columns);
  double widest = 1, highest = 1;
  for (const LinePlot& plot : plots) {
    widest = std::max(widest, plot.width);
    highest = std::max(highest, heightOf(plot));
  }
  const int width = static_cast<int>(std::lround(widest * scale));
  const int height = static_cast<int>(std::lround(highest * scale));
  cv::Mat image(rows * height, columns * width, CV_8UC3, cv::Scalar::all(255));
  for (int i = 0; i < count; ++i) {
    RasterCanvas canvas(image(cv::Rect(i % columns * width, i / columns * height, width, height)),
                        scale);
    draw(plots[static_cast<std::size_t>(i)], canvas);
  }
  return image;
}

}  // namespace svoscope
