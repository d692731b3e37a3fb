// SPDX-License-Identifier: MIT
#include "engine/detect/segment_detector.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/geometry/segment.h"

namespace svoscope {
namespace {

/// Grey image with a blurred step across each line, limited to the piece between its ends.
cv::Mat draw(const std::vector<DetectedSegment>& lines, double noise = 1.5) {
  cv::Mat image(480, 640, CV_8U);
  std::mt19937 rng(7);
  std::normal_distribution<double> grain(0, noise);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      double grey = 90;
      for (const DetectedSegment& l : lines) {
        const Vec2 d = (l.px[1] - l.px[0]).normalized(), p = Vec2(x, y) - l.px[0];
        const double across = lineThrough(l.px[0], l.px[1]).distance({double(x), double(y)});
        const double inside = std::min(d.dot(p), l.length() - d.dot(p));
        // A band of 14 px, bright at the line and fading out on the other side.
        const double band =
            1 / (1 + std::exp(-across / 0.6)) * std::exp(-std::pow(std::max(across, 0.0) / 9, 4));
        grey += 90 * band / (1 + std::exp(-inside));
      }
      image.at<std::uint8_t>(y, x) = cv::saturate_cast<std::uint8_t>(grey + grain(rng));
    }
  }
  return image;
}

DetectedSegment segment(double x0, double y0, double x1, double y1) {
  DetectedSegment s;
  s.px[0] = {x0, y0};
  s.px[1] = {x1, y1};
  return s;
}

const DetectedSegment* closestTo(const std::vector<DetectedSegment>& found,
                                 const DetectedSegment& truth, double within) {
  const ImageLine line = lineThrough(truth.px[0], truth.px[1]);
  for (const DetectedSegment& s : found) {
    if (std::abs(line.distance(s.px[0])) < within && std::abs(line.distance(s.px[1])) < within)
      return &s;
  }
  return nullptr;
}

TEST(SegmentDetector, FindsDrawnLinesWithTheirLength) {
  const std::vector<DetectedSegment> truth = {segment(80, 60, 300, 90), segment(400, 100, 430, 380),
                                              segment(100, 400, 320, 250)};
  const auto found = detectSegments(*buildPyramid(draw(truth), 3), {}, {});
  for (const DetectedSegment& t : truth) {
    const DetectedSegment* s = closestTo(found, t, 0.8);
    ASSERT_NE(s, nullptr);
    EXPECT_NEAR(s->length(), t.length(), 8);
  }
}

TEST(SegmentDetector, HasNoOffsetAcrossTheLine) {
  const std::vector<DetectedSegment> truth = {
      segment(80, 60, 300, 60), segment(400.3, 100, 400.3, 380), segment(100, 400, 320, 180)};
  const auto found = detectSegments(*buildPyramid(draw(truth, 0.5), 3), {}, {});
  for (const DetectedSegment& t : truth) {
    const DetectedSegment* s = closestTo(found, t, 1.5);
    ASSERT_NE(s, nullptr);
    EXPECT_LT(std::abs(lineThrough(t.px[0], t.px[1]).distance(0.5 * (s->px[0] + s->px[1]))), 0.25);
  }
}

TEST(SegmentDetector, MergesPiecesOfOneLineOnly) {
  const auto merged = mergeCollinear({segment(0, 0, 100, 0), segment(108, 0.5, 200, 0.5),
                                      segment(0, 20, 100, 20), segment(200, 1, 120, 1)},
                                     {});
  ASSERT_EQ(merged.size(), 3u);  // the last one has the opposite polarity
  EXPECT_NEAR(merged[0].length(), 200, 0.5);
}

TEST(SegmentDetector, LeavesOutWhatIsTrackedAndWhatIsShort) {
  const std::vector<DetectedSegment> truth = {segment(80, 60, 300, 90),
                                              segment(100, 300, 122, 310)};
  const auto pyramid = buildPyramid(draw(truth), 3);
  EXPECT_NE(closestTo(detectSegments(*pyramid, {}, {}), truth[0], 0.8), nullptr);
  EXPECT_EQ(closestTo(detectSegments(*pyramid, {}, {truth[0]}), truth[0], 0.8), nullptr);
  EXPECT_EQ(closestTo(detectSegments(*pyramid, {}, {}), truth[1], 0.8), nullptr);
}

}  // namespace
}  // namespace svoscope
