// SPDX-License-Identifier: MIT
#include "engine/figure/svg.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/figure/axis.h"
#include "engine/figure/svg_bars.h"
#include "engine/io/eval_plots.h"

namespace svoscope {
namespace {

int count(const std::string& text, const std::string& what) {
  int n = 0;
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += what.size()) ++n;
  return n;
}

TEST(Axis, TicksAreRoundAndInside) {
  const Axis linear = fitAxis({0.013, 0.047}, false, true);
  EXPECT_EQ(linear.low, 0);
  EXPECT_NEAR(linear.high, 0.05, 1e-12);
  EXPECT_EQ(linear.ticks().front(), 0);
  EXPECT_NEAR(linear.part(0.025), 0.5, 1e-9);
  const Axis log = fitAxis({0.003, 0.4, -1, NAN}, true, false);
  EXPECT_NEAR(log.low, 0.002, 1e-12);
  EXPECT_NEAR(log.high, 0.5, 1e-12);
  EXPECT_EQ(tickText(0.2), "0.2");
  EXPECT_GE(log.ticks().size(), 3u);
  for (const Axis& nothing :
       {fitAxis({}, false, false), fitAxis({NAN}, true, false), fitAxis({2, 2}, false, false)})
    EXPECT_GT(nothing.high, nothing.low);
}

TEST(Svg, TextsAreEscaped) {
  EXPECT_EQ(xmlEscaped("a<b & \"c\"\x01"), "a&lt;b &amp; &quot;c&quot;?");
  Svg svg(10, 10, "<label>");
  svg.text({0, 0}, "x & y", TextAnchor::start, "ink");
  EXPECT_NE(svg.inlined().find("x &amp; y"), std::string::npos);
  EXPECT_NE(svg.inlined().find("&lt;label&gt;"), std::string::npos);
}

TEST(SvgBars, MissingValuesAreADash) {
  SvgBarChart chart;
  chart.series = {{"a", {"#123456", ""}}, {"b", {"#654321", ""}}};
  chart.groups = {{"one", {SvgBar{1, 1, 1}, std::nullopt}}};
  const std::string svg = drawBars(chart).inlined();
  EXPECT_EQ(count(svg, ">-</text>"), 1);
  EXPECT_EQ(count(svg, "fill=\"#123456\""), 2);  // bar and legend
  EXPECT_EQ(count(svg, "fill=\"#654321\""), 1);  // legend only
}

TEST(EvalPlots, ThePlaneIsThatOfTheLargestExtents) {
  const PlotPlane plane = planeOf({Vec3(0, 0, 0), Vec3(1, 9, 4)});
  EXPECT_EQ(plane.u, 1);
  EXPECT_EQ(plane.v, 2);
}

TEST(EvalPlots, LongStepsAreGaps) {
  EXPECT_EQ(gapsIn({0, 1, 2, 3, 30, 31}), std::vector<std::size_t>{4});
  EXPECT_EQ(gapsIn({0, 1, 2, 5, 6}, 2.5), std::vector<std::size_t>{3});
  EXPECT_TRUE(gapsIn({0}).empty());
}

}  // namespace
}  // namespace svoscope
