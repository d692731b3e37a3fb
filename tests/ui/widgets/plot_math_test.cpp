// SPDX-License-Identifier: MIT
#include "ui/widgets/plot_math.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/widgets/image_view.h"
#include "ui/widgets/plot.h"
#include "ui/widgets/timeline.h"

namespace svoscope::ui {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

TEST(PlotMath, StepsAreOneTwoFive) {
  EXPECT_DOUBLE_EQ(niceStep(10, 10), 1);
  EXPECT_DOUBLE_EQ(niceStep(10, 6), 2);
  EXPECT_DOUBLE_EQ(niceStep(10, 3), 5);
  EXPECT_DOUBLE_EQ(niceStep(0.01, 4), 0.005);
  EXPECT_GT(niceStep(0, 4), 0);
}

TEST(PlotMath, TicksLieInsideAndAreFew) {
  for (const Range r : {Range{0, 1}, Range{-3.7, 11}, Range{1e6, 1e6 + 3}, Range{1e-7, 3e-7}}) {
    const auto ticks = linearTicks(r, 6);
    ASSERT_GE(ticks.size(), 2u);
    EXPECT_LE(ticks.size(), 7u);
    EXPECT_GE(ticks.front(), r.lo - 1e-9 * std::abs(r.lo));
    EXPECT_LE(ticks.back(), r.hi + 1e-9 * std::abs(r.hi));
  }
  EXPECT_TRUE(linearTicks({1, 1}, 5).empty());
  EXPECT_TRUE(linearTicks({0, INFINITY}, 5).empty());
}

TEST(PlotMath, LogTicksArePowersOfTen) {
  const auto ticks = logTicks({0.05, 200}, 8);
  ASSERT_EQ(ticks.size(), 4u);
  EXPECT_DOUBLE_EQ(ticks.front(), 0.1);
  EXPECT_DOUBLE_EQ(ticks.back(), 100);
}

TEST(PlotMath, LogTicksWithinADecadeLieOnBothSidesOfOne) {
  for (const Range r : {Range{0.25, 4}, Range{0.5, 2}, Range{0.3, 3}}) {
    for (const int count : {4, 8, 12}) {
      const auto ticks = logTicks(r, count);
      EXPECT_TRUE(std::any_of(ticks.begin(), ticks.end(), [](double t) { return t < 0.999; }))
          << r.lo << ", " << count;
      EXPECT_TRUE(std::any_of(ticks.begin(), ticks.end(), [](double t) { return t > 1.001; }))
          << r.lo << ", " << count;
      EXPECT_LE(static_cast<int>(ticks.size()), count + 1);
      EXPECT_TRUE(std::is_sorted(ticks.begin(), ticks.end()));
    }
  }
  EXPECT_TRUE(logTicks({0, 1}, 4).empty()) << "no log axis has a zero";
}

TEST(PlotMath, LogLabelsAreWhatTheyStandAt) {
  EXPECT_EQ(logTickLabel(0.25), "0.25");
  EXPECT_EQ(logTickLabel(1.5), "1.5");
  EXPECT_EQ(logTickLabel(0.001), "0.001");
  EXPECT_EQ(logTickLabel(2e-5), "2e-5");
  EXPECT_EQ(logTickLabel(1e4), "1e4");
}

TEST(PlotMath, LabelsTellTicksApart) {
  EXPECT_EQ(tickLabel(0.25, 0.05), "0.25");
  EXPECT_EQ(tickLabel(3, 1), "3");
  EXPECT_EQ(tickLabel(20000, 5000), "20k");
  EXPECT_EQ(tickLabel(0, 0.5), "0.0");
}

TEST(PlotMath, AxisGoesThereAndBack) {
  for (const bool log : {false, true}) {
    const Axis axis{{0.1, 1000}, 300, 20, log};
    for (const double v : {0.1, 1.0, 42.0, 1000.0}) {
      EXPECT_NEAR(axis.toData(axis.toPixel(v)), v, 1e-3 * v + (log ? 0 : 0.01));
    }
  }
  EXPECT_TRUE(std::isfinite((Axis{{5, 5}, 0, 100, false}).toPixel(5)));
}

TEST(PlotMath, RangesIgnoreWhatIsNotFinite) {
  const float values[] = {kNaN, 2, -1, INFINITY, 5};
  const Range r = finiteRange(values, 5, false);
  EXPECT_EQ(r.lo, -1);
  EXPECT_EQ(r.hi, 5);
  EXPECT_EQ(finiteRange(values, 5, true).lo, 2);
  const Range none = padded(finiteRange(values, 1, false), 0.1, false);
  EXPECT_LT(none.lo, none.hi);
  const Range flat = padded({3, 3}, 0.1, false);
  EXPECT_LT(flat.lo, 3);
  EXPECT_GT(flat.hi, 3);
}

TEST(PlotMath, ZoomKeepsTheCentre) {
  const Range r = zoomed({0, 10}, 4, 0.5, false);
  EXPECT_DOUBLE_EQ(r.lo, 2);
  EXPECT_DOUBLE_EQ(r.hi, 7);
  const Range l = zoomed({1, 100}, 10, 0.5, true);
  EXPECT_NEAR(std::sqrt(l.lo * l.hi), 10, 1e-9);
}

TEST(PlotMath, ThinningKeepsThePeak) {
  std::vector<float> x, y;
  for (int i = 0; i < 10000; ++i) {
    x.push_back(static_cast<float>(i));
    y.push_back(i == 7777 ? 100.0f : i == 1234 ? -50.0f : 0.0f);
  }
  const Axis xa{{0, 9999}, 0, 200, false}, ya{{-50, 100}, 150, 0, false};
  const auto runs = buildRuns(x.data(), y.data(), 10000, xa, ya);
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_LE(runs[0].size(), 4u * 202u);
  const auto by_y = [](ImVec2 a, ImVec2 b) { return a.y < b.y; };
  const auto [low, high] = std::minmax_element(runs[0].begin(), runs[0].end(), by_y);
  EXPECT_NEAR(low->y, 0, 1e-3);
  EXPECT_NEAR(high->y, 150, 1e-3);
}

TEST(PlotMath, RunsBreakAtNaN) {
  const float x[] = {0, 1, 2, 3, 4}, y[] = {1, 2, kNaN, 3, 4};
  const auto runs = buildRuns(x, y, 5, {{0, 4}, 0, 100, false}, {{0, 4}, 100, 0, false});
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0].size(), 2u);
}

TEST(Plot, CsvHoldsWhatIsShown) {
  const std::vector<float> x{0, 1, 2, 3}, a{1, kNaN, 3, 4}, b{9, 9, 9, 9};
  PlotSpec spec;
  spec.series = {{"a", &x, &a, 0}, {"b", &x, &b, 0}};
  PlotState state;
  state.hidden.insert("b");
  LinkedX linked{{1, 2}, false};
  EXPECT_EQ(plotCsv(spec, state, linked), "frame,a\n1,\n2,3\n");
}

TEST(ImageView, TransformsGoThereAndBack) {
  ImageView view;
  view.lo = {10, 20};
  view.hi = {410, 320};
  view.zoom = 3.5f;
  view.center = {100, 50};
  const Px px(123.25f, 40.5f);
  EXPECT_LT((view.toImage(view.toScreen(px)) - px).norm(), 1e-3f);
  EXPECT_FLOAT_EQ(fitZoom(640, 480, {320, 480}), 0.5f);
}

TEST(ImageView, ZoomingOutEndsAtFit) {
  ImageViewState state;
  zoomImage(state, 0.7f, 1.25f);
  EXPECT_GT(state.zoom, 0.7f);
  zoomImage(state, 0.7f, 0.5f);
  EXPECT_EQ(state.zoom, 0);
}

TEST(Timeline, PixelsAreFrames) {
  EXPECT_EQ(frameAtPixel(0, 0, 100, 50), 0);
  EXPECT_EQ(frameAtPixel(51, 0, 100, 50), 25);
  EXPECT_EQ(frameAtPixel(500, 0, 100, 50), 49);
  EXPECT_EQ(frameAtPixel(5, 0, 0, 50), 0);
}

}  // namespace
}  // namespace svoscope::ui
