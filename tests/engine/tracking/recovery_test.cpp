// SPDX-License-Identifier: MIT
#include "engine/tracking/recovery.h"

#include <gtest/gtest.h>

#include "tests/support/tracked_wall.h"

namespace svoscope {
namespace {

using test::TrackedWall;

Frame blackFrame() {
  Frame f;
  f.pyramid = buildPyramid(cv::Mat(240, 320, CV_8UC1, cv::Scalar(0)), TrackedWall::kLevels);
  return f;
}

TEST(Recovery, FindsTheCameraAtTheKeyframeThatLooksLikeIt) {
  const TrackedWall wall(4);
  const SE3 T = SE3(so3Exp(Vec3(0.01, 0.02, -0.01)), Vec3(0.03, -0.02, 0.05)) *
                wall.map.keyframes.at(2).T_cam_world;
  Recovery recovery;
  const auto result = recovery.find(wall.frame(9, T), wall.map, 0, {});
  ASSERT_TRUE(result.found) << result.text;
  EXPECT_TRUE(result.registration.good());
  EXPECT_EQ(result.text, "keyframe 2 by alignment");
  EXPECT_LT(
      (result.registration.T_cam_world.inverse().translation() - T.inverse().translation()).norm(),
      0.005);
}

TEST(Recovery, SaysWhichKeyframeWasRefusedAndWhy) {
  const TrackedWall wall(2);
  TrackerParameters p;
  p.quality.relocalized_inliers = 10000;
  Recovery recovery;
  const Frame frame = wall.frame(9, wall.map.keyframes.at(1).T_cam_world);
  const auto refused = recovery.find(frame, wall.map, 0, p);
  EXPECT_FALSE(refused.found);
  EXPECT_NE(refused.text.find("keyframe 1 by "), std::string::npos) << refused.text;
  EXPECT_NE(refused.text.find("10000 required"), std::string::npos) << refused.text;
  EXPECT_TRUE(refused.registration.judged);
  EXPECT_GT(refused.registration.funnel.inliers, 0);
  // Refused by its noise alone, an attempt leaves no numbers.
  p.quality.relocalized_noise = 1e-6;
  EXPECT_FALSE(recovery.find(frame, wall.map, 0.2, p).registration.judged);
}

TEST(Recovery, ABlackFrameIsFoundNowhere) {
  const TrackedWall wall(2);
  Recovery recovery;
  const auto result = recovery.find(blackFrame(), wall.map, 0, {});
  EXPECT_FALSE(result.found);
  EXPECT_FALSE(result.registration.judged);
  EXPECT_EQ(result.text, "no keyframe looks like this frame");
}

TEST(Recovery, LosesPatienceSoonerWithAFreshMap) {
  const TrackedWall fresh(1), old(4);
  QualityParameters q;
  q.fresh_lost_frames = 2;
  q.lost_frames = 4;
  Recovery recovery;
  std::vector<bool> with_fresh, with_old;
  for (int i = 0; i < 5; ++i) {
    recovery.find(blackFrame(), fresh.map, 0, {});
    with_fresh.push_back(recovery.impatient(fresh.map, q));
    with_old.push_back(recovery.impatient(old.map, q));
  }
  EXPECT_EQ(with_fresh, (std::vector<bool>{false, false, true, true, true}));
  EXPECT_EQ(with_old, (std::vector<bool>{false, false, false, false, true}));
  EXPECT_EQ(recovery.lostFrames(), 5);
  recovery.begin();
  EXPECT_FALSE(recovery.impatient(fresh.map, q)) << "lost anew";
}

}  // namespace
}  // namespace svoscope
