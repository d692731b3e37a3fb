// SPDX-License-Identifier: MIT
#include "engine/eval/estimate.h"

#include <gtest/gtest.h>

#include <cmath>

namespace svoscope {
namespace {

FrameRecord frame(int index, int map_id, bool good = true) {
  FrameRecord r;
  r.index = index;
  r.timestamp = index;
  r.map_id = map_id;
  r.pose_good = good;
  r.T_world_cam = SE3(Eigen::Quaterniond::Identity(), Vec3(index, map_id, 0));
  return r;
}

TEST(Estimate, IsOfTheMapWithMostPoses) {
  const std::vector<FrameRecord> records = {frame(0, 0, false), frame(1, 0), frame(2, 0),
                                            frame(3, 0, false), frame(4, 1), frame(5, 1),
                                            frame(6, 1),        frame(7, 2)};
  EXPECT_EQ(mainMap(records), 1);
  EXPECT_EQ(mapCount(records), 3);
  const Trajectory estimate = estimateOf(records);
  ASSERT_EQ(estimate.size(), 3u);
  for (const StampedPose& pose : estimate) EXPECT_EQ(pose.T_world_cam.translation().y(), 1);
}

TEST(Estimate, OfEqualsTheLaterCounts) { EXPECT_EQ(mainMap({frame(0, 0), frame(1, 1)}), 1); }

TEST(Estimate, WithoutPosesThereIsNone) {
  EXPECT_EQ(mainMap({}), -1);
  EXPECT_EQ(mainMap({frame(0, 0, false)}), -1);
  EXPECT_TRUE(estimateOf({frame(0, 0, false)}).empty());
}

TEST(Estimate, APoseThatIsNoNumberIsNone) {
  FrameRecord r = frame(0, 0);
  r.T_world_cam = SE3(Eigen::Quaterniond::Identity(), Vec3(NAN, 0, 0));
  EXPECT_FALSE(hasPoseIn(r, 0));
  EXPECT_EQ(mapCount({r}), 0);
}

}  // namespace
}  // namespace svoscope
