// SPDX-License-Identifier: MIT
#include "engine/tracking/segment_pose.h"

#include <gtest/gtest.h>

#include <random>

#include "engine/tracking/pose_refinement.h"

namespace svoscope {
namespace {

struct SegmentPoseTest : testing::Test {
  Pinhole camera{640, 480, 500, 500, 319.5, 239.5};
  SE3 T_true{so3Exp({0.05, -0.1, 0.02}), {0.1, -0.05, 0.2}};
  std::vector<SegmentPoseObservation> lines;

  SegmentPoseTest() {
    std::mt19937 rng(5);
    std::uniform_real_distribution<double> u(-1, 1);
    for (int i = 0; i < 25; ++i) {
      SegmentPoseObservation o;
      for (Vec3& p : o.p_world) p = Vec3(1.2 * u(rng), 0.9 * u(rng), 3 + 1.5 * u(rng));
      o.line =
          lineThrough(camera.project(T_true * o.p_world[0]), camera.project(T_true * o.p_world[1]));
      lines.push_back(o);
    }
  }
};

TEST_F(SegmentPoseTest, GradientAgreesWithFiniteDifferences) {
  const SE3 T =
      SE3::exp((Vec6() << 0.004, -0.003, 0.005, 0.001, -0.002, 0.003).finished()) * T_true;
  // A wide scale leaves the weights near one: b is then minus half the gradient of the cost.
  constexpr double kScale = 1e4;
  Mat6 H = Mat6::Zero();
  Vec6 b = Vec6::Zero();
  addSegmentTerms(camera, lines, T, kScale, 1, H, b);
  const auto cost = [&](const SE3& pose) {
    double sum = 0, e[2];
    for (const auto& o : lines) {
      EXPECT_TRUE(segmentResiduals(camera, o, pose, e));
      sum += (e[0] * e[0] + e[1] * e[1]) / (kScale * kScale);
    }
    return sum;
  };
  for (int k = 0; k < 6; ++k) {
    const Vec6 d = 1e-6 * Vec6::Unit(k);
    const double slope = (cost(SE3::exp(d) * T) - cost(SE3::exp(-d) * T)) / 2e-6;
    EXPECT_NEAR(-2 * b[k], slope, 1e-4 * b.norm()) << k;
  }
}

TEST_F(SegmentPoseTest, LinesAloneFixThePoseDespiteOutliers) {
  for (int i = 0; i < 5; ++i) lines[static_cast<std::size_t>(i)].line.offset += 6 + i;
  const SE3 start =
      SE3::exp((Vec6() << 0.01, -0.01, 0.01, 0.004, -0.004, 0.004).finished()) * T_true;
  const PoseRefinementResult r = refinePose(camera, {}, start, {}, lines, {});
  ASSERT_TRUE(r.ok);
  EXPECT_EQ(r.segment_inliers, 20);
  EXPECT_LT((r.T_cam_world * T_true.inverse()).log().norm(), 1e-6);
}

TEST_F(SegmentPoseTest, WhatDoesNotInformHasNoInfluence) {
  for (SegmentPoseObservation& o : lines) o.informs = false;
  Mat6 H = Mat6::Zero();
  Vec6 b = Vec6::Zero();
  addSegmentTerms(camera, lines, SE3(), 1, 1, H, b);
  EXPECT_EQ(H, Mat6::Zero());
}

}  // namespace
}  // namespace svoscope
