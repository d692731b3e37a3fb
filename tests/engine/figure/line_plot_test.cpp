// SPDX-License-Identifier: MIT
// The same plot as vector graphics and as an image.
#include "engine/figure/line_plot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <regex>

namespace svoscope {
namespace {

constexpr double kScale = 2;

/// x: 0 to 4, nothing at 2; y: three decades on a logarithmic axis.
LinePlot madePlot() {
  LinePlot plot;
  plot.title = "Made";
  plot.x_label = "time, s";
  plot.y_label = "error, m";
  plot.log_y = true;
  plot.series.push_back({"first", {"#0072b2", ""}, {0, 1, 2, 3, 4}, {1, 10, NAN, 100, 1000}});
  return plot;
}

int count(const std::string& text, const std::string& what) {
  int n = 0;
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += what.size()) ++n;
  return n;
}

/// Points of every polyline, px of the figure.
std::vector<std::vector<FigurePoint>> polylinesOf(const std::string& svg) {
  std::vector<std::vector<FigurePoint>> lines;
  const std::regex polyline("<polyline points=\"([^\"]*)\""), pair("([0-9.-]+),([0-9.-]+)");
  for (std::sregex_iterator l(svg.begin(), svg.end(), polyline), end; l != end; ++l) {
    const std::string points = (*l)[1];
    lines.emplace_back();
    for (std::sregex_iterator p(points.begin(), points.end(), pair); p != end; ++p)
      lines.back().push_back({std::stod((*p)[1]), std::stod((*p)[2])});
  }
  return lines;
}

/// Pixels of a colour in a box of the figure.
int countOf(const cv::Mat& image, const cv::Vec3b& bgr, FigurePoint low, FigurePoint high) {
  const cv::Rect box(cv::Point(cv::Point2d(low.x, low.y) * kScale),
                     cv::Point(cv::Point2d(high.x, high.y) * kScale));
  int count = 0;
  for (const cv::Vec3b& pixel : cv::Mat_<cv::Vec3b>(image(box).clone())) count += pixel == bgr;
  return count;
}

bool inked(const cv::Mat& image, FigurePoint low, FigurePoint high) {
  const int area = static_cast<int>((high.x - low.x) * (high.y - low.y) * kScale * kScale);
  return countOf(image, {255, 255, 255}, low, high) < area;
}

const cv::Vec3b kBlue(0xb2, 0x72, 0x00);

TEST(LinePlot, TheImageShowsWhatTheSvgSays) {
  const LinePlot plot = madePlot();
  const std::string svg = drawSvg(plot).inlined();
  const cv::Mat image = drawRaster({plot}, 1, kScale);
  ASSERT_EQ(image.cols, kScale * plot.width);
  ASSERT_EQ(image.rows, kScale * heightOf(plot));
  for (const char* text : {"Made", "time, s", "error, m", "first", "1", "10", "100", "1000"})
    EXPECT_NE(svg.find(std::string(">") + text + "</text>"), std::string::npos) << text;
  EXPECT_TRUE(inked(image, {56, 4}, {100, 18}));                   // title
  EXPECT_TRUE(inked(image, {330, 284}, {370, 294}));               // label of x
  EXPECT_TRUE(inked(image, {2, 120}, {16, 170}));                  // label of y
  EXPECT_TRUE(inked(image, {22, 20}, {52, 34}));                   // topmost tick of y
  EXPECT_GT(countOf(image, kBlue, {56, 300}, {90, 310}), 32);      // legend
  EXPECT_EQ(countOf(image, kBlue, {0, 0}, {56, plot.height}), 0);  // nothing left of the axis
  const auto lines = polylinesOf(svg);
  ASSERT_EQ(lines.size(), 2u);
  for (const auto& line : lines) {
    for (const FigurePoint& p : line)
      EXPECT_GT(countOf(image, kBlue, {p.x - 3, p.y - 3}, {p.x + 3, p.y + 3}), 0) << p.x;
  }
}

TEST(LinePlot, AValueThatIsNotThereInterruptsTheLine) {
  const LinePlot plot = madePlot();
  const auto lines = polylinesOf(drawSvg(plot).inlined());
  ASSERT_EQ(lines.size(), 2u);
  const cv::Mat image = drawRaster({plot}, 1, kScale);
  const double before = lines[0].back().x, after = lines[1].front().x;
  ASSERT_GT(after - before, 50);
  EXPECT_EQ(countOf(image, kBlue, {before + 4, 26}, {after - 4, 260}), 0);
  EXPECT_GT(countOf(image, kBlue, {before - 30, 26}, {before, 260}), 0);
}

TEST(LinePlot, DecadesAreEquallyHighOnALogarithmicAxis) {
  LinePlot plot = madePlot();
  plot.series[0].y = {1, 10, 100, 0, 1000};  // zero has no place there
  const auto lines = polylinesOf(drawSvg(plot).inlined());
  ASSERT_EQ(lines.size(), 1u);  // and 1000 is alone
  ASSERT_EQ(lines[0].size(), 3u);
  const auto& p = lines[0];
  EXPECT_NEAR(p[0].y - p[1].y, p[1].y - p[2].y, 0.2);
  EXPECT_GT(p[0].y - p[1].y, 50);
  const cv::Mat image = drawRaster({plot}, 1, kScale);
  EXPECT_GT(countOf(image, kBlue, {p[1].x - 3, p[1].y - 3}, {p[1].x + 3, p[1].y + 3}), 0);
}

TEST(LinePlot, ADashedLineHasGapsInTheImageToo) {
  LinePlot plot = madePlot();
  plot.log_y = false;
  plot.series[0] = {"", {"#0072b2", ""}, {0, 1, 2, 3, 4}, {1, 1, 1, 1, 1}};
  const auto blue = [&] {
    return countOf(drawRaster({plot}, 1, kScale), kBlue, {56, 26}, {628, 260});
  };
  const int solid = blue();
  plot.series[0].style.dash = "10 10";
  EXPECT_NE(drawSvg(plot).inlined().find("stroke-dasharray=\"10 10\""), std::string::npos);
  const int dashed = blue();
  EXPECT_GT(dashed, solid / 4);
  EXPECT_LT(dashed, 3 * solid / 4);
}

TEST(LinePlot, CurvesAreInterruptedWhereThereIsNoValue) {
  LinePlot plot;
  plot.series.push_back({"a", {"#123456", ""}, {0, 1, 2, 3, 4}, {1, 2, NAN, 2, 1}});
  EXPECT_EQ(count(drawSvg(plot).inlined(), "<polyline"), 2);
  plot.losses = {{1, 1}};
  EXPECT_EQ(count(drawSvg(plot).inlined(), "<path"), 1);
}

TEST(LinePlot, EqualAxesHaveOneScale) {
  LinePlot plot;
  plot.equal_axes = true;
  plot.series.push_back({"", {"#123456", ""}, {0, 10, 10, 0, 0}, {0, 0, 1, 1, 0}});
  const std::string svg = drawSvg(plot).inlined();
  const std::size_t at = svg.find("points=\"") + 8;
  double x[3], y[3];
  ASSERT_EQ(std::sscanf(svg.c_str() + at, "%lf,%lf %lf,%lf %lf,%lf", &x[0], &y[0], &x[1], &y[1],
                        &x[2], &y[2]),
            6);
  EXPECT_NEAR((x[1] - x[0]) / 10, y[1] - y[2], 0.2);
}

TEST(LinePlot, PlotsStandInRowsOfTheHighest) {
  LinePlot plot = madePlot();
  const double high = heightOf(plot);
  LinePlot bare = plot;
  bare.series[0].name.clear();  // no legend
  EXPECT_LT(heightOf(bare), high);
  const cv::Mat image = drawRaster({bare, plot, bare}, 2, 1);
  EXPECT_EQ(image.cols, 2 * plot.width);
  EXPECT_EQ(image.rows, 2 * high);
}

}  // namespace
}  // namespace svoscope
