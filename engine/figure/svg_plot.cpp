// SPDX-License-Identifier: MIT
#include "engine/figure/svg_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/figure/axis.h"

namespace svoscope {

namespace {

constexpr double kLeft = 56, kRight = 12, kTop = 26, kBottom = 40, kLegendRow = 18;
constexpr double kGlyph = 6.8;  // px, about the width of a letter

class Plot {
 public:
  explicit Plot(const SvgPlot& p) : p_(p), svg_(p.width, p.height + legendHeight(p), label(p)) {
    right_ = p.width - kRight;
    bottom_ = p.height - kBottom;
    std::vector<double> xs, ys;
    for (const SvgCurve& c : p.curves) {
      xs.insert(xs.end(), c.x.begin(), c.x.end());
      ys.insert(ys.end(), c.y.begin(), c.y.end());
    }
    const AxisFit fit = p.equal_axes ? AxisFit::tight : AxisFit::round;
    x_ = fitAxis(xs, false, false, p.equal_axes ? fit : AxisFit::tight, steps(right_ - kLeft, 70));
    y_ = fitAxis(ys, p.log_y, p.from_zero && !p.equal_axes, fit, steps(bottom_ - kTop, 34));
    if (p.equal_axes) equalise();
  }

  Svg draw() {
    svg_.text({kLeft, 15}, p_.title, SvgAnchor::start, "title");
    drawAxes();
    svg_.beginClip({kLeft, kTop}, right_ - kLeft, bottom_ - kTop);
    for (const SvgCurve& c : p_.curves) drawCurve(c);
    for (const SvgPoint& loss : p_.losses)
      svg_.cross(at(loss.x, loss.y), 3.5, "class=\"loss\" stroke-width=\"1.4\"");
    svg_.endClip();
    drawLegend();
    return svg_;
  }

 private:
  static int steps(double px, double each) { return std::max(2, static_cast<int>(px / each)); }
  static std::string label(const SvgPlot& p) {
    return p.title + ": " + p.y_label + " over " + p.x_label;
  }

  static double entryWidth(const SvgCurve& c) {
    return 40 + kGlyph * static_cast<double>(c.name.size()) + 14;
  }

  /// Rows the legend needs.
  static int legendRows(const SvgPlot& p) {
    double x = kLeft;
    int rows = 0;
    for (const SvgCurve& c : p.curves) {
      if (c.name.empty()) continue;
      if (rows == 0 || x + entryWidth(c) > p.width) {
        ++rows;
        x = kLeft;
      }
      x += entryWidth(c);
    }
    return rows;
  }
  static double legendHeight(const SvgPlot& p) { return kLegendRow * legendRows(p); }

  void equalise() {
    const double w = right_ - kLeft, h = bottom_ - kTop;
    const double unit = std::max((x_.high - x_.low) / w, (y_.high - y_.low) / h);
    const auto widen = [unit](Axis& axis, double px) {
      const double middle = 0.5 * (axis.low + axis.high);
      axis.low = middle - 0.5 * unit * px;
      axis.high = middle + 0.5 * unit * px;
    };
    widen(x_, w);
    widen(y_, h);
    x_.step = niceStep(x_.high - x_.low, steps(w, 70));
    y_.step = niceStep(y_.high - y_.low, steps(h, 45));
  }

  SvgPoint at(double x, double y) const {
    return {kLeft + x_.part(x) * (right_ - kLeft), bottom_ - y_.part(y) * (bottom_ - kTop)};
  }

  void drawAxes() {
    for (const double v : y_.ticks()) {
      const double y = at(x_.low, v).y;
      svg_.line({kLeft, y}, {right_, y}, "class=\"grid\"");
      svg_.text({kLeft - 5, y + 4}, tickText(v), SvgAnchor::end, "dim");
    }
    for (const double v : x_.ticks()) {
      const double x = at(v, y_.low).x;
      svg_.line({x, kTop}, {x, bottom_}, "class=\"grid\"");
      svg_.text({x, bottom_ + 15}, tickText(v), SvgAnchor::middle, "dim");
    }
    svg_.rect({kLeft, kTop}, right_ - kLeft, bottom_ - kTop, "class=\"axis\"");
    svg_.text({0.5 * (kLeft + right_), bottom_ + 32}, p_.x_label, SvgAnchor::middle, "dim");
    svg_.turnedText({12, 0.5 * (kTop + bottom_)}, p_.y_label, "dim");
  }

  void drawCurve(const SvgCurve& c) {
    std::vector<SvgPoint> piece;
    const auto flush = [&] {
      // A pose between two losses would vanish as a line without length.
      if (piece.size() == 1)
        svg_.circle(piece[0], 0.6 * c.width, "fill=\"none\" " + c.style.stroke(c.width));
      if (piece.size() > 1) svg_.polyline(piece, c.style.stroke(c.width));
      piece.clear();
    };
    for (std::size_t i = 0; i < std::min(c.x.size(), c.y.size()); ++i) {
      if (std::isfinite(c.x[i]) && std::isfinite(c.y[i]) && (!p_.log_y || c.y[i] > 0)) {
        piece.push_back(at(c.x[i], c.y[i]));
      } else {
        flush();
      }
    }
    flush();
  }

  void drawLegend() {
    double x = kLeft, y = p_.height + 4;
    for (const SvgCurve& c : p_.curves) {
      if (c.name.empty()) continue;
      if (x > kLeft && x + entryWidth(c) > p_.width) {
        x = kLeft;
        y += kLegendRow;
      }
      svg_.line({x, y}, {x + 32, y}, c.style.stroke(2));
      svg_.text({x + 38, y + 4}, c.name, SvgAnchor::start, "ink");
      x += entryWidth(c);
    }
  }

  const SvgPlot& p_;
  Svg svg_;
  Axis x_, y_;
  double right_ = 0, bottom_ = 0;
};

}  // namespace

std::string SvgStyle::stroke(double width) const {
  const std::string dashes = dash.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", dash);
  const std::string ink = color.empty() ? "class=\"truth\"" : fmt::format("stroke=\"{}\"", color);
  return fmt::format("{} stroke-width=\"{:.1f}\" stroke-linejoin=\"round\"{}", ink, width, dashes);
}

std::string SvgStyle::fill() const {
  const std::string ink = color.empty() ? "class=\"ink\"" : fmt::format("fill=\"{}\"", color);
  return opacity < 1 ? ink + fmt::format(" fill-opacity=\"{:g}\"", opacity) : ink;
}

Svg drawPlot(const SvgPlot& plot) { return Plot(plot).draw(); }

}  // namespace svoscope
