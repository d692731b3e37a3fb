// SPDX-License-Identifier: MIT
#include "engine/match/patch.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/plane_scene.h"

namespace svoscope {
namespace {

SE3 randomMotion(std::mt19937& rng) {
  std::uniform_real_distribution<double> u(-1, 1);
  Vec6 twist;
  for (int i = 0; i < 6; ++i) twist[i] = 0.25 * u(rng);
  return SE3::exp(twist);
}

TEST(AffineWarp, IsTheDerivativeOfTheWarpOfAFrontoParallelPlane) {
  const Pinhole camera = test::smallCamera();
  std::mt19937 rng(2);
  constexpr double h = 1e-4;  // px
  for (const Vec2& px : {Vec2(160, 120), Vec2(40, 30), Vec2(290, 200)}) {
    const SE3 T = randomMotion(rng);
    const double distance = 2.3, z = camera.bearing(px).z() * distance;
    const auto warp = [&](const Vec2& at) {
      return camera.project(T * (camera.unproject(at) * z));
    };
    Mat2 numeric;
    for (int k = 0; k < 2; ++k) {
      const Vec2 step = h * Vec2::Unit(k);
      numeric.col(k) = (warp(px + step) - warp(px - step)) / (2 * h);
    }
    const Mat2 A = affineWarp(camera, T, camera.bearing(px), distance);
    EXPECT_LT((A - numeric).norm(), 1e-6);
  }
}

TEST(AffineWarp, NoMotionIsTheIdentity) {
  const Pinhole camera = test::smallCamera();
  const Vec2 px(70, 200);
  EXPECT_LT((affineWarp(camera, SE3(), camera.bearing(px), 3) - Mat2::Identity()).norm(), 1e-12);
}

/// grey = 10 + 2 x + y: integers, so bilinear sampling is exact.
cv::Mat ramp(int size) {
  cv::Mat image(size, size, CV_8UC1);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      image.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>(10 + 2 * x + y);
  return image;
}

TEST(WarpPatch, IsExactOnALinearRamp) {
  const cv::Mat image = ramp(80);
  Mat2 A;
  A << 1.2, 0.3, -0.2, 0.9;
  const Vec2 px(40.25, 38.5);
  WarpedPatch patch;
  ASSERT_TRUE(warpPatch(image, px, 0, A, 0, patch));
  const Mat2 inverse = A.inverse();
  for (int row = -1; row <= kPatchSize; ++row) {
    for (int column = -1; column <= kPatchSize; ++column) {
      const Vec2 at = px + inverse * Vec2(column - kPatchHalf, row - kPatchHalf);
      ASSERT_NEAR(patch.inner(row, column), 10 + 2 * at.x() + at.y(), 2e-3) << row << ' ' << column;
    }
  }
}

TEST(WarpPatch, LevelsScaleTheFootprint) {
  const cv::Mat image = ramp(80);
  WarpedPatch fine, coarse;
  ASSERT_TRUE(warpPatch(image, Vec2(40, 40), 0, Mat2::Identity(), 0, fine));
  ASSERT_TRUE(warpPatch(image, Vec2(40, 40), 0, Mat2::Identity(), 1, coarse));
  EXPECT_NEAR(fine.inner(4, 5) - fine.inner(4, 4), 2, 1e-4);
  EXPECT_NEAR(coarse.inner(4, 5) - coarse.inner(4, 4), 4, 1e-4);
  // The feature stays at the patch's centre on every level of the reference.
  const cv::Mat half = halfSample(image);
  WarpedPatch from_half;
  ASSERT_TRUE(warpPatch(half, Vec2(40, 40), 1, Mat2::Identity(), 1, from_half));
  EXPECT_NEAR(from_half.inner(4, 4), coarse.inner(4, 4), 0.6);  // rounding of the 2x2 mean
}

TEST(WarpPatch, RefusesPatchesThatLeaveTheImageAndSingularWarps) {
  const cv::Mat image = ramp(80);
  WarpedPatch patch;
  EXPECT_TRUE(warpPatch(image, Vec2(5, 5), 0, Mat2::Identity(), 0, patch));
  EXPECT_FALSE(warpPatch(image, Vec2(4.9, 40), 0, Mat2::Identity(), 0, patch));
  EXPECT_FALSE(warpPatch(image, Vec2(40, 74), 0, Mat2::Identity(), 0, patch));
  EXPECT_FALSE(warpPatch(image, Vec2(40, 40), 0, Mat2::Identity() * 0.1, 0, patch));  // reach 50 px
  EXPECT_FALSE(warpPatch(image, Vec2(40, 40), 0, Mat2::Zero(), 0, patch));
  const double nan = std::nan("");
  EXPECT_FALSE(warpPatch(image, Vec2(nan, 40), 0, Mat2::Identity(), 0, patch));
  EXPECT_FALSE(warpPatch(image, Vec2(40, 40), 0, Mat2::Constant(nan), 0, patch));
}

TEST(SearchLevel, ClimbsWhileThePatchAppearsEnlarged) {
  const auto scaled = [](double s) { return Mat2(Mat2::Identity() * s); };
  EXPECT_EQ(searchLevel(scaled(1), 0, 4), 0);
  EXPECT_EQ(searchLevel(scaled(1.7), 0, 4), 0);
  EXPECT_EQ(searchLevel(scaled(2), 0, 4), 1);
  EXPECT_EQ(searchLevel(scaled(1), 2, 4), 2);
  EXPECT_EQ(searchLevel(scaled(0.5), 2, 4), 1);
  EXPECT_EQ(searchLevel(scaled(100), 0, 3), 3);
  EXPECT_EQ(searchLevel(scaled(0.01), 2, 4), 0);
}

TEST(Bilinear, InterpolatesBetweenPixels) {
  cv::Mat image = (cv::Mat_<std::uint8_t>(2, 2) << 10, 20, 30, 80);
  EXPECT_FLOAT_EQ(bilinear(image, 0, 0), 10);
  EXPECT_FLOAT_EQ(bilinear(image, 0.5f, 0), 15);
  EXPECT_FLOAT_EQ(bilinear(image, 0.5f, 0.5f), 35);
}

}  // namespace
}  // namespace svoscope
