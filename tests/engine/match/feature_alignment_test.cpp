// SPDX-License-Identifier: MIT
#include "engine/match/feature_alignment.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "engine/detect/feature_detector.h"
#include "tests/support/plane_scene.h"

namespace svoscope {
namespace {

constexpr double kUnitsPerPx = 2.0 / 300;  // on the plane at z = 2

test::PlaneScene scene() { return {test::smallCamera(), Vec3::UnitZ(), 2, 9 * kUnitsPerPx}; }

/// The scene moved in the image by `shift` px.
SE3 shifted(const Vec2& shift) {
  return SE3(Eigen::Quaterniond::Identity(), Vec3(shift.x(), shift.y(), 0) * kUnitsPerPx);
}

WarpedPatch patchAt(const cv::Mat& image, const Vec2& px) {
  WarpedPatch patch;
  EXPECT_TRUE(warpPatch(image, px, 0, Mat2::Identity(), 0, patch));
  return patch;
}

/// Pixels with structure in both directions, as the detector would choose them.
std::vector<Vec2> corners(const cv::Mat& image) {
  std::vector<Vec2> pixels;
  for (const Vec2& px : test::gridPixels(test::smallCamera(), 12, 30)) {
    if (cornerScore(image, static_cast<int>(px.x()), static_cast<int>(px.y())) > 8)
      pixels.push_back(px);
  }
  EXPECT_GT(pixels.size(), 30u);
  return pixels;
}

struct Errors {
  int converged = 0, tried = 0;
  double worst = 0, sum = 0;
};

Errors alignEverywhere(const cv::Mat& ref, const cv::Mat& cur, const Vec2& shift,
                       double start_error, const FeatureAlignmentParameters& p = {}) {
  Errors e;
  for (const Vec2& px : corners(scene().render(SE3()))) {
    const Vec2 start = px + shift + start_error * Vec2(0.8, -0.6);
    const AlignmentResult r = alignPatch2D(cur, patchAt(ref, px), start, p);
    ++e.tried;
    if (!r.converged) continue;
    ++e.converged;
    const double error = (r.px - px - shift).norm();
    e.worst = std::max(e.worst, error);
    e.sum += error;
  }
  return e;
}

TEST(FeatureAlignment, RecoversShifts) {
  const cv::Mat ref = scene().render(SE3());
  // Bilinear sampling smooths most half-way between pixels: a bias that no iteration removes.
  for (const auto& [shift, limit] :
       {std::pair(Vec2(1, 0), 0.003), std::pair(Vec2(-0.85, 0.1), 0.02),
        std::pair(Vec2(0.1, 0.15), 0.02), std::pair(Vec2(0.3, -0.2), 0.03),
        std::pair(Vec2(0.5, 0.5), 0.04)}) {
    const Errors e = alignEverywhere(ref, scene().render(shifted(shift)), shift, 0.6);
    EXPECT_EQ(e.converged, e.tried);
    EXPECT_LT(e.sum / e.converged, limit) << shift.transpose();
  }
}

TEST(FeatureAlignment, RecoversShiftsWithAFixedGain) {
  FeatureAlignmentParameters fixed;
  fixed.estimate_gain = false;
  const cv::Mat ref = scene().render(SE3());
  for (const auto& [shift, limit] :
       {std::pair(Vec2(0, 0), 0.015), std::pair(Vec2(-0.85, 0.1), 0.03)}) {
    const Errors e =
        alignEverywhere(ref, scene().render(shifted(shift), {1, 20}), shift, 0.6, fixed);
    EXPECT_EQ(e.converged, e.tried);
    EXPECT_LT(e.sum / e.converged, limit) << shift.transpose();
  }
}

TEST(FeatureAlignment, GainAndOffsetChangeNothing) {
  const cv::Mat ref = scene().render(SE3(), {0.6, 10});
  const Vec2 shift(-0.85, 0.1);
  const Errors e =
      alignEverywhere(ref, scene().render(shifted(shift), {0.6 * 1.3, 10 * 1.3 + 20}), shift, 0.6);
  EXPECT_EQ(e.converged, e.tried);
  EXPECT_LT(e.sum / e.converged, 0.025);
}

TEST(FeatureAlignment, WithoutGainEstimationTheResidualTellsOfIt) {
  const cv::Mat ref = scene().render(SE3(), {0.6, 10}), cur = scene().render(SE3(), {0.9, 10});
  FeatureAlignmentParameters fixed;
  fixed.estimate_gain = false;
  const Vec2 px(160, 120);
  const AlignmentResult with = alignPatch2D(cur, patchAt(ref, px), px, {});
  const AlignmentResult without = alignPatch2D(cur, patchAt(ref, px), px, fixed);
  EXPECT_LT(with.rms, 1);
  EXPECT_GT(without.rms, 3 * with.rms);
}

TEST(FeatureAlignment, OneDimensionMovesAlongTheDirectionOnly) {
  const cv::Mat ref = scene().render(SE3());
  for (const double degrees : {0.0, 50.0, 130.0}) {
    const Vec2 direction(std::cos(degrees * M_PI / 180), std::sin(degrees * M_PI / 180));
    const Vec2 shift = 0.7 * direction;
    const cv::Mat cur = scene().render(shifted(shift));
    double sum = 0;
    int converged = 0;
    for (const Vec2& px : corners(ref)) {
      const AlignmentResult r = alignPatch1D(cur, patchAt(ref, px), px, direction, {});
      if (!r.converged) continue;
      ++converged;
      sum += std::abs(direction.dot(r.px - px - shift));
      EXPECT_NEAR(Vec2(-direction.y(), direction.x()).dot(r.px - px), 0, 1e-4);
    }
    EXPECT_GE(converged, 20);
    EXPECT_LT(sum / converged, 0.02) << degrees;
  }
}

TEST(FeatureAlignment, TheFirstStepIsGaussNewtons) {
  // For a tiny shift one step of the inverse compositional method is the linear least-squares
  // solution: image derivatives taken by finite differences of renderings must agree with it.
  const cv::Mat ref = scene().render(SE3());
  FeatureAlignmentParameters one;
  one.max_iterations = 2;
  one.min_step_px = 10;  // converged after the first step
  const Vec2 shift(0.1, -0.07);
  const cv::Mat cur = scene().render(shifted(shift));
  for (const Vec2& px : corners(ref)) {
    const AlignmentResult r = alignPatch2D(cur, patchAt(ref, px), px, one);
    ASSERT_TRUE(r.converged);
    ASSERT_EQ(r.iterations, 1);
    EXPECT_LT((r.px - px - shift).norm(), 0.35 * shift.norm()) << px.transpose();
  }
}

TEST(FeatureAlignment, RefusesFlatPatches) {
  const cv::Mat flat(100, 100, CV_8UC1, cv::Scalar(90));
  EXPECT_FALSE(alignPatch2D(flat, patchAt(flat, {50, 50}), {50, 50}, {}).converged);
  EXPECT_FALSE(alignPatch1D(flat, patchAt(flat, {50, 50}), {50, 50}, {1, 0}, {}).converged);
}

TEST(FeatureAlignment, RefusesAnEdgeInTwoDimensionsButNotAcross) {
  cv::Mat edge(100, 100, CV_8UC1);
  for (int x = 0; x < 100; ++x)
    edge.col(x).setTo(cv::saturate_cast<std::uint8_t>(120 + 80 * std::tanh(0.5 * (x - 50))));
  EXPECT_FALSE(alignPatch2D(edge, patchAt(edge, {50, 50}), {50, 50}, {}).converged);
  EXPECT_TRUE(alignPatch1D(edge, patchAt(edge, {50, 50}), {50.5, 50}, {1, 0}, {}).converged);
  EXPECT_FALSE(alignPatch1D(edge, patchAt(edge, {50, 50}), {50, 50}, {0, 1}, {}).converged);
}

TEST(FeatureAlignment, RefusesTheWrongPatch) {
  const cv::Mat ref = scene().render(SE3());
  const test::PlaneScene other(test::smallCamera(), Vec3::UnitZ(), 2, 10 * kUnitsPerPx, 99);
  const cv::Mat cur = other.render(SE3());
  int refused = 0, tried = 0;
  for (const Vec2& px : test::gridPixels(test::smallCamera(), 30, 40)) {
    ++tried;
    refused += !alignPatch2D(cur, patchAt(ref, px), px, {}).converged;
  }
  EXPECT_GT(refused, 0.7 * tried);
}

TEST(FeatureAlignment, RefusesStartsNearTheBorderAndNaN) {
  const cv::Mat ref = scene().render(SE3());
  const WarpedPatch patch = patchAt(ref, {160, 120});
  const double nan = std::nan("");
  for (const Vec2& start : {Vec2(3.9, 100), Vec2(100, 3), Vec2(315.1, 100), Vec2(100, 236),
                            Vec2(-50, -50), Vec2(1e9, 100), Vec2(nan, 100), Vec2(100, nan)})
    EXPECT_FALSE(alignPatch2D(ref, patch, start, {}).converged) << start.transpose();
}

TEST(FeatureAlignment, AcceptsUpToTheResidualLimit) {
  const cv::Mat ref = scene().render(SE3());
  cv::Mat noisy;
  cv::Mat noise(ref.size(), CV_16SC1);
  cv::RNG(4).fill(noise, cv::RNG::NORMAL, 0, 6);
  cv::add(ref, noise, noisy, cv::noArray(), CV_8U);
  FeatureAlignmentParameters strict;
  strict.max_mean_error = 3;
  const WarpedPatch patch = patchAt(ref, {160, 120});
  const AlignmentResult loose = alignPatch2D(noisy, patch, {160, 120}, {});
  EXPECT_TRUE(loose.converged);
  EXPECT_NEAR(loose.rms, 6, 2);
  EXPECT_FALSE(alignPatch2D(noisy, patch, {160, 120}, strict).converged);
}

}  // namespace
}  // namespace svoscope
