// SPDX-License-Identifier: MIT
#include "engine/eval/conventions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace svoscope {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A walk with turns about all axes, 20 Hz.
Trajectory walk(double clock = 0) {
  Trajectory poses;
  for (int i = 0; i < 400; ++i) {
    const double t = 0.05 * i, s = t + clock;
    const Vec3 p(2 * std::sin(0.7 * s), std::cos(1.1 * s) + 0.3 * s, 0.5 * std::sin(1.9 * s));
    const Eigen::Quaterniond q(Eigen::AngleAxisd(0.8 * std::sin(0.9 * s), Vec3::UnitX()) *
                               Eigen::AngleAxisd(1.2 * std::cos(0.5 * s), Vec3::UnitZ()) *
                               Eigen::AngleAxisd(0.4 * s, Vec3::UnitY()));
    poses.push_back({100 + t, SE3(q, p)});
  }
  return poses;
}

std::vector<ConventionDoubt> doubtsOf(const Trajectory& truth, const Trajectory& estimate) {
  const auto result = evaluate(truth, estimate);
  EXPECT_TRUE(result.ok());
  return conventionDoubts(truth, estimate, result.value(), true, true);
}

TEST(Conventions, WhatIsRightRaisesNoDoubt) { EXPECT_THAT(doubtsOf(walk(), walk()), IsEmpty()); }

TEST(Conventions, ClocksApart) {
  Trajectory late = walk();
  for (StampedPose& pose : late) pose.timestamp += 0.35;
  const auto doubts = doubtsOf(walk(), late);
  ASSERT_EQ(doubts.size(), 1u);
  EXPECT_THAT(doubts[0].option, HasSubstr("--offset -0.35"));
}

TEST(Conventions, InverseAndMirror) {
  const auto inverse = doubtsOf(walk(), invertedPoses(walk()));
  ASSERT_FALSE(inverse.empty());
  EXPECT_EQ(inverse[0].option, "--invert");
  const auto mirror = doubtsOf(walk(), mirroredPoses(walk()));
  ASSERT_FALSE(mirror.empty());
  EXPECT_EQ(mirror[0].option, "--mirror");
}

TEST(Conventions, QuaternionsThatBeginWithW) {
  Trajectory written = walk();  // w x y z, read as x y z w
  for (StampedPose& pose : written) {
    const Eigen::Quaterniond q = pose.T_world_cam.quaternion();
    pose.T_world_cam =
        SE3(Eigen::Quaterniond(q.z(), q.w(), q.x(), q.y()), pose.T_world_cam.translation());
  }
  const auto doubts = doubtsOf(walk(), written);
  ASSERT_EQ(doubts.size(), 1u);
  EXPECT_EQ(doubts[0].option, "--quaternion est-wxyz");
  const Trajectory mended = reorderedQuaternions(written);
  EXPECT_LT(mended[7].T_world_cam.quaternion().angularDistance(walk()[7].T_world_cam.quaternion()),
            1e-9);
}

TEST(Conventions, ClocksThatDoNotOverlapNameTheOffset) {
  Trajectory zero = walk();
  for (StampedPose& pose : zero) pose.timestamp -= 100;
  EXPECT_THAT(clockDoubt(walk(), zero), HasSubstr("--offset 100"));
  EXPECT_EQ(clockDoubt(walk(), walk()), "");
}

}  // namespace
}  // namespace svoscope
