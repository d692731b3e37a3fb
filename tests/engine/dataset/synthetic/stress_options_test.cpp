// SPDX-License-Identifier: MIT
// Options that make tracking hard: the truth must stay exact under each.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "engine/dataset/synthetic/synthetic.h"

namespace svoscope {
namespace {

std::unique_ptr<Sequence> open(const std::string& text) {
  auto opened = openSyntheticSequence("synthetic:" + text);
  if (!opened.ok()) throw std::runtime_error(opened.error().message());
  return std::move(opened.value());
}

cv::Mat gray(Sequence& s, int index) { return s.read(index).value().gray; }

double fraction(const cv::Mat& mask) {
  return cv::countNonZero(mask) / static_cast<double>(mask.total());
}

/// Pixels whose depth differs between two images.
cv::Mat changed(const cv::Mat& a, const cv::Mat& b) {
  cv::Mat difference;
  cv::absdiff(a, b, difference);
  return difference > 1e-6;
}

TEST(SyntheticStress, MoversMoveWhileTheCameraStandsStill) {
  const auto empty = open("still?size=160x120&noise=0&frames=40");
  const auto moving = open("still?size=160x120&noise=0&frames=40&movers=3");
  EXPECT_EQ(fraction(changed(empty->readDepth(0).value(), empty->readDepth(30).value())), 0);
  const cv::Mat first = moving->readDepth(0).value(), later = moving->readDepth(30).value();
  EXPECT_GT(fraction(changed(first, later)), 0.03);
  EXPECT_EQ(fraction(changed(later, moving->readDepth(30).value())), 0);
}

TEST(SyntheticStress, MoversHideTheSceneAndLeaveTheRestAsItWas) {
  const auto without = open("room?size=160x120&noise=0&frames=20");
  const auto with = open("room?size=160x120&noise=0&frames=20&movers=3");
  const cv::Mat scene = without->readDepth(12).value(), seen = with->readDepth(12).value();
  cv::Mat mask = changed(scene, seen);
  ASSERT_GT(fraction(mask), 0.02);
  EXPECT_EQ(cv::countNonZero((seen > scene) & mask), 0) << "a mover is in front of what it hides";
  cv::dilate(mask, mask, cv::Mat(), {-1, -1}, 2);  // silhouettes are smooth
  const cv::Mat difference = cv::abs(gray(*without, 12) - gray(*with, 12));
  EXPECT_EQ(cv::countNonZero(difference & ~mask), 0);
  EXPECT_GT(cv::mean(difference, mask)[0], 5);
}

TEST(SyntheticStress, EveryPresetHasMoversInView) {
  for (const NamedText& preset : syntheticPresets()) {
    const std::string options = "?size=160x120&noise=0&frames=200";
    const auto without = open(preset.name + options);
    const auto with = open(preset.name + options + "&movers=4");
    double mean = 0, most = 0;
    for (int i = 0; i < 200; i += 20) {
      const double covered =
          fraction(changed(without->readDepth(i).value(), with->readDepth(i).value()));
      mean += covered / 10;
      most = std::max(most, covered);
    }
    EXPECT_GT(mean, 0.02) << preset.name;
    EXPECT_LT(mean, 0.4) << preset.name;
    EXPECT_LT(most, 0.7) << preset.name << ": the camera goes through a mover";
  }
}

TEST(SyntheticStress, FaintTexturesKeepGreyLevelsAndDepths) {
  const auto full = open("room?size=320x240&noise=0&frames=5");
  const auto faint = open("room?size=320x240&noise=0&frames=5&texture=0.2");
  cv::Mat edges_full, edges_faint;
  cv::Laplacian(gray(*full, 2), edges_full, CV_32F);
  cv::Laplacian(gray(*faint, 2), edges_faint, CV_32F);
  cv::Scalar unused, deviation_full, deviation_faint;
  cv::meanStdDev(edges_full, unused, deviation_full);
  cv::meanStdDev(edges_faint, unused, deviation_faint);
  EXPECT_LT(deviation_faint[0], 0.5 * deviation_full[0]);
  EXPECT_GT(deviation_faint[0], 0.1 * deviation_full[0]);
  EXPECT_NEAR(cv::mean(gray(*full, 2))[0], cv::mean(gray(*faint, 2))[0], 6);
  EXPECT_EQ(fraction(changed(full->readDepth(2).value(), faint->readDepth(2).value())), 0);
}

TEST(SyntheticStress, StepsHaveExactlyTheRatioAskedFor) {
  const auto s = open("still?size=160x120&noise=0&frames=110&texture=0.3&step=1.3");
  const auto ratio = [&](int index) {
    return cv::mean(gray(*s, index))[0] / cv::mean(gray(*s, 0))[0];
  };
  EXPECT_NEAR(ratio(24), 1, 1e-9);
  EXPECT_NEAR(ratio(25), 1.3, 0.01);
  EXPECT_NEAR(ratio(50), 1, 1e-9);
  EXPECT_NEAR(ratio(75), 1 / 1.3, 0.01);
  EXPECT_NEAR(ratio(100), 1, 1e-9);
}

TEST(SyntheticStress, TravelScalesTheTranslationOnly) {
  const auto full = open("spin?size=64x48&frames=60");
  const auto little = open("spin?size=64x48&frames=60&travel=0.1");
  for (int i : {0, 20, 59}) {
    const SE3 &a = full->groundTruth()[i].T_world_cam, &b = little->groundTruth()[i].T_world_cam;
    const Vec3 start = full->groundTruth()[0].T_world_cam.translation();
    EXPECT_LT((0.1 * (a.translation() - start) - (b.translation() - start)).norm(), 1e-12);
    EXPECT_LT(a.quaternion().angularDistance(b.quaternion()), 1e-12);
  }
}

TEST(SyntheticStress, ValuesOutOfRangeNameTheRange) {
  const auto error = [](const std::string& option) {
    const auto opened = openSyntheticSequence("synthetic:room?" + option);
    return opened.ok() ? std::string("opened") : opened.error().message();
  };
  EXPECT_THAT(error("movers=13"), testing::HasSubstr("0..12"));
  EXPECT_THAT(error("movers=1.5"), testing::HasSubstr("no valid value"));
  EXPECT_THAT(error("texture=2"), testing::HasSubstr("0..1"));
  EXPECT_THAT(error("step=0.5"), testing::HasSubstr("1..3"));
}

}  // namespace
}  // namespace svoscope
