// SPDX-License-Identifier: MIT
#include "engine/dataset/synthetic/synthetic.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

namespace svoscope {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::unique_ptr<Sequence> open(const std::string& text) {
  auto opened = openSyntheticSequence(text);
  if (!opened.ok()) throw std::runtime_error(opened.error().message());
  return std::move(opened.value());
}

cv::Mat gray(Sequence& s, int index) { return s.read(index).value().gray; }

bool same(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) == 0;
}

/// Median |difference| and median displacement of frame `a` reprojected into frame `b`.
struct Agreement {
  double gray = 0, motion = 0;
  int compared = 0;
};

double median(std::vector<double>& v) {
  if (v.empty()) return 0;
  std::nth_element(v.begin(), v.begin() + v.size() / 2, v.end());
  return v[v.size() / 2];
}

Agreement reproject(Sequence& s, int a, int b) {
  const Pinhole& p = s.camera().pinhole;
  const cv::Mat from = gray(s, a), to = gray(s, b);
  const cv::Mat z_from = s.readDepth(a).value(), z_to = s.readDepth(b).value();
  const SE3 T_b_a = s.groundTruth()[b].T_world_cam.inverse() * s.groundTruth()[a].T_world_cam;
  std::vector<double> differences, motions;
  for (int y = 1; y < p.height; y += 2) {
    for (int x = 1; x < p.width; x += 2) {
      const double z = z_from.at<float>(y, x);
      if (z <= 0) continue;
      const Vec3 q = T_b_a * (p.unproject(Vec2(x, y)) * z);
      if (q.z() < 0.1) continue;
      const Vec2 px = p.project(q);
      if (!p.inside(px, 1)) continue;
      const int u = static_cast<int>(px.x()), v = static_cast<int>(px.y());
      if (std::abs(z_to.at<float>(v, u) - q.z()) > 0.03 * q.z()) continue;  // hidden there
      const double ax = px.x() - u, ay = px.y() - v;
      const auto at = [&](int i, int j) { return static_cast<double>(to.at<uchar>(v + j, u + i)); };
      const double value = (1 - ay) * ((1 - ax) * at(0, 0) + ax * at(1, 0)) +
                           ay * ((1 - ax) * at(0, 1) + ax * at(1, 1));
      differences.push_back(std::abs(value - from.at<uchar>(y, x)));
      motions.push_back((px - Vec2(x, y)).norm());
    }
  }
  const int compared = static_cast<int>(differences.size());
  return {median(differences), median(motions), compared};
}

TEST(Synthetic, DepthAndPosesExplainTheImages) {
  for (const NamedText& preset : syntheticPresets()) {
    const int width = preset.name == "floor" ? 376 : 320;
    const auto s = open("synthetic:" + preset.name +
                        "?noise=0&frames=30&size=" + std::to_string(width) + "x240");
    const Agreement result = reproject(*s, 2, 5);
    EXPECT_GT(result.compared, 8000) << preset.name;
    EXPECT_LT(result.gray, 4) << preset.name;
    if (preset.name == "still")
      EXPECT_LT(result.motion, 1e-3);
    else
      EXPECT_GT(result.motion, 0.5) << preset.name;
  }
}

TEST(Synthetic, FramesHaveContrastAndTruthMovesFromTheStart) {
  for (const char* name : {"room", "desk", "spin"}) {
    const auto s = open(std::string("synthetic:") + name + "?size=320x240");
    cv::Scalar mean, deviation;
    cv::meanStdDev(gray(*s, 0), mean, deviation);
    EXPECT_GT(deviation[0], 20) << name;
    EXPECT_NEAR(mean[0], 125, 50) << name;
    const Trajectory& t = s->groundTruth();
    ASSERT_EQ(t.size(), 300u);
    const double moved = (t[30].T_world_cam.translation() - t[0].T_world_cam.translation()).norm();
    EXPECT_GT(moved, 0.08) << name;
    for (size_t i = 1; i < t.size(); ++i) {
      const Vec6 step = (t[i - 1].T_world_cam.inverse() * t[i].T_world_cam).log();
      EXPECT_LT(step.tail<3>().norm(), 0.03) << name << " turns too fast at frame " << i;
      EXPECT_LT(step.head<3>().norm(), 0.06) << name << " moves too fast at frame " << i;
    }
  }
}

TEST(Synthetic, SameTextSameBytesInAnyOrder) {
  const std::string text =
      "synthetic:desk?size=160x120&frames=40&blur=0.5&light=1&occlude=0.1&seed=7";
  const auto a = open(text), b = open(text);
  const cv::Mat third = gray(*a, 3);
  gray(*b, 30);
  gray(*b, 7);
  EXPECT_TRUE(same(gray(*b, 3), third));
  EXPECT_TRUE(same(gray(*a, 30), gray(*b, 30)));
  EXPECT_TRUE(same(a->readDepth(9).value(), b->readDepth(9).value()));
  const auto other = open("synthetic:desk?size=160x120&frames=40&seed=8");
  EXPECT_FALSE(same(gray(*other, 3), third));
}

TEST(Synthetic, NoiseHasTheDeviationAskedFor) {
  const auto clean = open("synthetic:still?size=320x240&noise=0&frames=2");
  const auto noisy = open("synthetic:still?size=320x240&noise=4&frames=2");
  cv::Mat difference;
  cv::subtract(gray(*noisy, 0), gray(*clean, 0), difference, cv::noArray(), CV_32F);
  cv::Scalar mean, deviation;
  cv::meanStdDev(difference, mean, deviation);
  EXPECT_NEAR(mean[0], 0, 0.1);
  EXPECT_NEAR(deviation[0], 4, 0.15);
  EXPECT_FALSE(same(gray(*noisy, 0), gray(*noisy, 1))) << "each frame has its own noise";
  EXPECT_TRUE(same(gray(*clean, 0), gray(*clean, 1)));
}

TEST(Synthetic, BlackoutAndLightAndSpeed) {
  const auto s = open("synthetic:still?size=160x120&noise=0&frames=60&light=1&blackout=10:5");
  for (int i : {9, 10, 14, 15}) {
    const bool black = i >= 10 && i < 15;
    EXPECT_EQ(cv::countNonZero(gray(*s, i)) == 0, black) << i;
  }
  const double before = cv::mean(gray(*s, 24))[0], after = cv::mean(gray(*s, 25))[0];
  const double ratio = std::max(before, after) / std::min(before, after);
  EXPECT_GT(ratio, 1.05);
  EXPECT_LT(ratio, 1.31);
  const auto slow = open("synthetic:room?size=64x48&frames=21");
  const auto fast = open("synthetic:room?size=64x48&frames=11&speed=2");
  const SE3 delta =
      slow->groundTruth()[20].T_world_cam.inverse() * fast->groundTruth()[10].T_world_cam;
  EXPECT_LT(delta.log().norm(), 1e-9);
}

TEST(Synthetic, OccluderCoversTheFractionAskedFor) {
  const auto s = open("synthetic:room?size=160x120&frames=20&occlude=0.3");
  const cv::Mat depth = s->readDepth(11).value();
  const double covered = cv::countNonZero(depth < 0.5) / static_cast<double>(depth.total());
  EXPECT_NEAR(covered, 0.3, 0.02);
}

TEST(Synthetic, FocalLengthFollowsTheWidth) {
  EXPECT_EQ(open("synthetic:still?frames=1")->camera().pinhole.fx, 525);
  EXPECT_EQ(open("synthetic:still?frames=1&size=320x200")->camera().pinhole.fx, 262.5);
  const auto floor = open("synthetic:floor?frames=1");
  EXPECT_EQ(floor->camera().pinhole.width, 752);
  EXPECT_EQ(floor->camera().pinhole.fx, 315);
  EXPECT_EQ(parseSyntheticSpec("synthetic:forward").value().rate_hz, 10);
}

TEST(Synthetic, WrongWordsListTheRightOnes) {
  const auto error = [](const std::string& text) {
    const auto opened = openSyntheticSequence(text);
    if (opened.ok()) return std::string("opened");
    EXPECT_EQ(opened.error().kind, ErrorKind::usage);
    return opened.error().message();
  };
  EXPECT_THAT(error("synthetic:attic"), AllOf(HasSubstr("'attic'"), HasSubstr("corridor")));
  EXPECT_THAT(error("synthetic:"), HasSubstr("presets are"));
  EXPECT_THAT(error("synthetic:room?fog=1"), AllOf(HasSubstr("'fog'"), HasSubstr("blackout")));
  EXPECT_THAT(error("synthetic:room?frames=0"), HasSubstr("1..100000"));
  EXPECT_THAT(error("synthetic:room?frames=2.5"), HasSubstr("'frames=2.5'"));
  EXPECT_THAT(error("synthetic:room?noise"), HasSubstr("noise: image noise"));
  EXPECT_THAT(error("synthetic:room?size=640"), HasSubstr("WIDTHxHEIGHT"));
  EXPECT_THAT(error("synthetic:room?noise=nan"), HasSubstr("no valid value"));
  EXPECT_THAT(error("synthetic:room?"), HasSubstr("unknown option ''"));
}

}  // namespace
}  // namespace svoscope
