// SPDX-License-Identifier: MIT
#include "engine/runner/trajectory_runner.h"

#include <gtest/gtest.h>

namespace svoscope {
namespace {

using Kind = Command::Kind;

TrajectoryFile fileOf(const std::vector<double>& times) {
  TrajectoryFile file;
  for (const double t : times)
    file.poses.push_back({t, SE3(Eigen::Quaterniond::Identity(), Vec3(t, 0, 0))});
  return file;
}

RunInfo poseInfo() {
  RunInfo info;
  info.sequence = "synthetic:fake";
  info.method = "orb";
  return info;
}

TEST(TrajectoryRunner, PosesGoToTheFramesNearestInTime) {
  const FrameTimes frames{10, {1.0, 1.1, 1.2, 1.3}};
  auto made =
      TrajectoryRunner::make(fileOf({1.09, 1.104, 1.25, 1.31}), frames, poseInfo(), "orb.txt");
  ASSERT_TRUE(made.ok()) << made.error().message();
  Runner& run = *made.value();
  Command to;
  to.kind = Kind::play;
  run.send(to);
  while (run.pump()) {
  }
  const auto rows = run.records(0);
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[0].index, 10);
  EXPECT_FALSE(rows[0].pose_good);
  ASSERT_TRUE(rows[1].pose_good);
  EXPECT_DOUBLE_EQ(rows[1].T_world_cam.translation().x(), 1.104) << "of two poses the nearer one";
  EXPECT_FALSE(rows[2].pose_good) << "50 ms away";
  EXPECT_TRUE(rows[3].pose_good);
  EXPECT_TRUE(run.status().finished);
}

TEST(TrajectoryRunner, RowsWithoutTimesAreThoseOfTheFrames) {
  TrajectoryFile file = fileOf({0, 1, 2, 3, 4});
  file.format = TrajectoryFormat::kitti;
  auto made = TrajectoryRunner::make(file, {3, {0.3, 0.4, 0.5}}, poseInfo(), "00.txt");
  ASSERT_TRUE(made.ok());
  Command to;
  to.kind = Kind::play;
  made.value()->send(to);
  while (made.value()->pump()) {
  }
  const auto rows = made.value()->records(0);
  EXPECT_DOUBLE_EQ(rows[0].T_world_cam.translation().x(), 3);
  EXPECT_TRUE(rows[1].pose_good);
  EXPECT_FALSE(rows[2].pose_good) << "the file has fewer rows than the sequence frames";
}

TEST(TrajectoryRunner, PosesOfAnotherSequenceAreRefused) {
  const auto made =
      TrajectoryRunner::make(fileOf({500, 501}), {0, {1.0, 1.1}}, poseInfo(), "other.txt");
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().kind, ErrorKind::input);
  EXPECT_EQ(made.error().where, "other.txt");
}

}  // namespace
}  // namespace svoscope
