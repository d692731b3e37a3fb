// SPDX-License-Identifier: MIT
#include "engine/figure/svg_bars.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/figure/axis.h"
#include "engine/figure/legend.h"
#include "engine/figure/svg_canvas.h"

namespace svoscope {

namespace {

constexpr double kTop = 26, kRight = 24, kBottom = 40, kGap = 9;

class Bars {
 public:
  explicit Bars(const SvgBarChart& c)
      : c_(c),
        row_(c.series.size() > 5 ? 9 : 12),
        svg_(c.width, height(c, row_), c.title + ": " + c.x_label) {
    std::size_t longest = 0;
    std::vector<double> values;
    for (const SvgBarGroup& group : c.groups) {
      longest = std::max(longest, group.label.size());
      for (const auto& bar : group.bars) {
        if (!bar) continue;
        values.insert(values.end(), {bar->value, bar->low, bar->high});
      }
    }
    if (c.reference) values.push_back(*c.reference);
    left_ = std::min(0.4 * c.width, LegendRows::kGlyph * static_cast<double>(longest) + 14);
    right_ = c.width - kRight;
    bottom_ = kTop + groupsHeight(c, row_);
    x_ = fitAxis(values, c.log, !c.log && !c.dots, AxisFit::round, 6);
  }

  Svg draw() {
    svg_.text({4, 15}, c_.title, TextAnchor::start, "title");
    drawAxis();
    double y = kTop + 0.5 * kGap;
    for (const SvgBarGroup& group : c_.groups) {
      const double height = row_ * static_cast<double>(c_.series.size());
      svg_.text({left_ - 8, y + 0.5 * height + 4}, group.label, TextAnchor::end, "ink");
      for (std::size_t i = 0; i < c_.series.size(); ++i)
        drawBar(group.bars.size() > i ? group.bars[i] : std::nullopt, c_.series[i].style,
                y + row_ * (static_cast<double>(i) + 0.5));
      y += height + kGap;
    }
    drawLegend();
    return svg_;
  }

 private:
  static double groupsHeight(const SvgBarChart& c, double row) {
    return static_cast<double>(c.groups.size()) *
           (row * static_cast<double>(c.series.size()) + kGap);
  }
  static LegendRows legendOf(const SvgBarChart& c) { return {4, c.width, 26}; }
  static double legendHeight(const SvgBarChart& c) {
    if (c.series.size() < 2) return 0;
    LegendRows rows = legendOf(c);
    for (const SvgBarSeries& s : c.series) rows.place(s.name);
    return rows.height();
  }
  static double height(const SvgBarChart& c, double row) {
    return kTop + groupsHeight(c, row) + kBottom + legendHeight(c);
  }

  double px(double v) const { return left_ + x_.part(v) * (right_ - left_); }

  void drawAxis() {
    for (const double v : x_.ticks()) {
      svg_.line({px(v), kTop}, {px(v), bottom_}, "class=\"grid\"");
      svg_.text({px(v), bottom_ + 15}, tickText(v), TextAnchor::middle, "dim");
    }
    svg_.line({left_, bottom_}, {right_, bottom_}, "class=\"axis\"");
    if (c_.reference)
      svg_.line({px(*c_.reference), kTop}, {px(*c_.reference), bottom_},
                "class=\"axis\" stroke-width=\"1.5\"");
    svg_.text({0.5 * (left_ + right_), bottom_ + 32}, c_.x_label, TextAnchor::middle, "dim");
  }

  void drawBar(const std::optional<SvgBar>& bar, const FigureStyle& style, double y) {
    if (!bar) {
      svg_.text({left_ + 4, y + 4}, "-", TextAnchor::start, "dim");
      return;
    }
    const std::string fill = svgFill(style);
    const bool dots = c_.log || c_.dots;
    if (!dots)
      svg_.rect({left_, y - 0.5 * row_ + 1}, std::max(0.0, px(bar->value) - left_), row_ - 2, fill);
    if (bar->high > bar->low) {
      const std::string ink = dots && !style.color.empty()
                                  ? fmt::format("stroke=\"{}\" stroke-width=\"2\"", style.color)
                                  : "class=\"loss\" stroke-width=\"1\"";
      svg_.line({px(bar->low), y}, {px(bar->high), y}, ink);
      for (const double end : {bar->low, bar->high})
        svg_.line({px(end), y - 2.5}, {px(end), y + 2.5}, ink);
    }
    if (dots) svg_.circle({px(bar->value), y}, 3.5, fill);
  }

  void drawLegend() {
    if (c_.series.size() < 2) return;
    LegendRows rows = legendOf(c_);
    for (const SvgBarSeries& s : c_.series) {
      const FigurePoint entry = rows.place(s.name);
      const double x = entry.x, y = bottom_ + kBottom + 8 + entry.y;
      svg_.rect({x, y - 9}, 16, 10, svgFill(s.style));
      svg_.text({x + 22, y}, s.name, TextAnchor::start, "ink");
    }
  }

  const SvgBarChart& c_;
  double row_;
  Svg svg_;
  Axis x_;
  double left_ = 0, right_ = 0, bottom_ = 0;
};

}  // namespace

Svg drawBars(const SvgBarChart& chart) { return Bars(chart).draw(); }

}  // namespace svoscope
