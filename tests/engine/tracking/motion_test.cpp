// SPDX-License-Identifier: MIT
#include "engine/tracking/motion.h"

#include <gtest/gtest.h>

#include "tests/support/tracked_wall.h"

namespace svoscope {
namespace {

using test::TrackedWall;

TEST(Motion, PredictsWhatExplainsTheImageBest) {
  const TrackedWall wall;
  const Frame last = wall.registered(0, wall.map.keyframes.at(0));
  const SE3 step = TrackedWall::shifted(0.06);
  Motion motion;
  motion.begin(SE3(), step);
  const auto goes_on = motion.predict(wall.frame(1, step), last, wall.map.camera, {});
  ASSERT_EQ(goes_on.size(), 3u);
  EXPECT_EQ(goes_on[0].T_cur_last.matrix(), step.matrix());
  EXPECT_EQ(goes_on[1].T_cur_last.matrix(), SE3().matrix());
  EXPECT_FALSE(goes_on[0].wide || goes_on[1].wide);
  EXPECT_TRUE(goes_on[2].wide);
  const auto stands = motion.predict(wall.frame(1, SE3()), last, wall.map.camera, {});
  EXPECT_EQ(stands[0].T_cur_last.matrix(), SE3().matrix());
  EXPECT_EQ(stands[1].T_cur_last.matrix(), step.matrix());
}

TEST(Motion, VelocityIsThatOfTheLastTwoGoodFrames) {
  Motion motion;
  Frame last, frame;
  last.T_cam_world = TrackedWall::shifted(1);
  frame.T_cam_world = TrackedWall::shifted(1.5);
  motion.moved(frame, last);
  EXPECT_NEAR(motion.velocity().translation().x(), 0.5, 1e-12);
  EXPECT_EQ(motion.lastGoodPose().matrix(), frame.T_cam_world.matrix());
  motion.foundAt(TrackedWall::shifted(3));
  EXPECT_EQ(motion.velocity().matrix(), SE3().matrix()) << "nothing is known after a loss";
  EXPECT_NEAR(motion.lastGoodPose().translation().x(), 3, 1e-12);
}

TEST(Motion, UsualNoiseIsARunningMean) {
  Motion motion;
  EXPECT_EQ(motion.usualNoisePx(), 0);
  motion.noteNoise(1);
  EXPECT_EQ(motion.usualNoisePx(), 1) << "the first frame decides alone";
  motion.noteNoise(2);
  EXPECT_NEAR(motion.usualNoisePx(), 1.05, 1e-12);
}

TEST(Motion, FollowsAnAdjustedKeyframe) {
  Motion motion;
  motion.begin(TrackedWall::shifted(1), TrackedWall::shifted(0.5));
  motion.follow({SE3(), TrackedWall::shifted(0, 2), 3});
  EXPECT_NEAR(motion.velocity().translation().x(), 1.5, 1e-12);
  EXPECT_NEAR(motion.lastGoodPose().translation().x(), 3, 1e-12);
  EXPECT_NEAR(motion.lastGoodPose().translation().y(), 2, 1e-12);
}

}  // namespace
}  // namespace svoscope
