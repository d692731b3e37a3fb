// SPDX-License-Identifier: MIT
#include "engine/frame/pyramid.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

namespace svoscope {
namespace {

cv::Mat randomImage(int width, int height) {
  cv::Mat image(height, width, CV_8UC1);
  cv::RNG rng(5);
  rng.fill(image, cv::RNG::UNIFORM, 0, 256);
  return image;
}

TEST(Pyramid, EveryPixelIsTheRoundedMeanOfFour) {
  for (const cv::Size& size : {cv::Size(64, 48), cv::Size(65, 49), cv::Size(1241, 37)}) {
    const cv::Mat image = randomImage(size.width, size.height), half = halfSample(image);
    ASSERT_EQ(half.size(), cv::Size(size.width / 2, size.height / 2));
    for (int y = 0; y < half.rows; ++y) {
      for (int x = 0; x < half.cols; ++x) {
        int sum = 0;
        for (int k = 0; k < 4; ++k) sum += image.at<std::uint8_t>(2 * y + k / 2, 2 * x + k % 2);
        ASSERT_EQ(half.at<std::uint8_t>(y, x), (sum + 2) / 4) << x << ", " << y;
      }
    }
  }
}

TEST(Pyramid, ImagesWithPaddedRowsAreSampledAlike) {
  const cv::Mat wide = randomImage(100, 60), part = wide(cv::Rect(7, 3, 51, 41));
  EXPECT_EQ(cv::norm(halfSample(part), halfSample(part.clone()), cv::NORM_INF), 0);
}

TEST(Pyramid, AVerticalEdgeStaysVerticalWithOddWidths) {
  cv::Mat image(376, 1241, CV_8UC1, cv::Scalar(20));
  image(cv::Rect(640, 0, 1241 - 640, 376)).setTo(220);
  const PyramidPtr pyramid = buildPyramid(image, 5);
  ASSERT_EQ(pyramid->size(), 5u);  // 376 -> 23 rows
  for (const cv::Mat& level : *pyramid) {
    for (int y = 1; y < level.rows; ++y)
      ASSERT_EQ(cv::norm(level.row(0), level.row(y), cv::NORM_INF), 0)
          << level.cols << " row " << y;
  }
  EXPECT_EQ((*pyramid)[1].cols, 620);
  EXPECT_EQ((*pyramid)[3].cols, 155);
}

TEST(Pyramid, StopsBeforeASideFallsBelow14) {
  EXPECT_EQ(buildPyramid(randomImage(64, 28), 5)->size(), 2u);
  EXPECT_EQ(buildPyramid(randomImage(64, 27), 5)->size(), 1u);
  EXPECT_EQ(buildPyramid(randomImage(640, 480), 3)->size(), 3u);
  EXPECT_EQ(buildPyramid(randomImage(3, 2), 5)->size(), 1u);
}

TEST(Pyramid, LevelZeroIsTheImageItself) {
  const cv::Mat image = randomImage(64, 48);
  EXPECT_EQ(buildPyramid(image, 2)->front().data, image.data);
}

TEST(Pyramid, LevelsGrowWithTheWidth) {
  EXPECT_EQ(pyramidLevels(640), 5);
  EXPECT_EQ(pyramidLevels(1241), 6);
  EXPECT_EQ(pyramidLevels(320), 4);
  EXPECT_EQ(pyramidLevels(0), 3);
  EXPECT_EQ(pyramidLevels(100000), 7);
}

TEST(Pyramid, CoordinatesPointAtTheSameContentOnEveryLevel) {
  // A ramp: grey = x + 2 y. The 2x2 mean of a ramp is the ramp at the block's centre.
  cv::Mat image(64, 64, CV_8UC1);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      image.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>(x + 2 * y);
  const cv::Mat half = halfSample(image);
  for (const Vec2& px : {Vec2(3, 5), Vec2(20, 7)}) {
    const Vec2 fine = fromLevel(px, 1);
    EXPECT_NEAR(half.at<std::uint8_t>(int(px.y()), int(px.x())), fine.x() + 2 * fine.y(), 0.51);
  }
  EXPECT_EQ(fromLevel(Vec2(0, 0), 1), Vec2(0.5, 0.5));
  EXPECT_EQ(toLevel(Vec2(0.5, 0.5), 1), Vec2(0, 0));
  for (int level = 0; level < 6; ++level) {
    const Vec2 px(123.25, 77.5);
    EXPECT_LT((fromLevel(toLevel(px, level), level) - px).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace svoscope
