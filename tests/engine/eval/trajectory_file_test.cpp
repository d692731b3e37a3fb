// SPDX-License-Identifier: MIT
#include "engine/eval/trajectory_file.h"

#include <gtest/gtest.h>

#include "tests/support/support.h"

namespace svoscope {
namespace {

Result<TrajectoryFile> load(const std::string& text,
                            TrajectoryUse use = TrajectoryUse::ground_truth) {
  const test::TemporaryFolder folder;
  test::writeText(folder / "poses.txt", text);
  return loadTrajectory(folder / "poses.txt", {use});
}

void expectError(const std::string& text, const std::string& line, const std::string& what,
                 TrajectoryUse use = TrajectoryUse::estimate) {
  const auto result = load(text, use);
  ASSERT_FALSE(result.ok()) << text;
  EXPECT_EQ(result.error().kind, ErrorKind::input);
  EXPECT_NE(result.error().where.find("poses.txt" + line), std::string::npos)
      << result.error().message();
  EXPECT_NE(result.error().what.find(what), std::string::npos) << result.error().message();
}

TEST(TrajectoryFile, ReadsTum) {
  const auto result = load(
      "# timestamp tx ty tz qx qy qz qw\r\n\n1.5 1 2 3 0 0 0 1\r\n"
      "  2.5\t1 2 4   0 0 1 0 # note\n");
  ASSERT_TRUE(result.ok()) << result.error().message();
  EXPECT_EQ(result.value().format, TrajectoryFormat::tum);
  ASSERT_EQ(result.value().poses.size(), 2u);
  EXPECT_DOUBLE_EQ(result.value().poses[0].timestamp, 1.5);
  EXPECT_EQ(result.value().poses[1].T_world_cam.translation(), Vec3(1, 2, 4));
  EXPECT_DOUBLE_EQ(result.value().poses[1].T_world_cam.quaternion().z(), 1);
}

TEST(TrajectoryFile, ReadsTumWithNanoseconds) {
  const auto result = load("1403636580838555648.000000 1 2 3 0 0 0 1\n");
  ASSERT_TRUE(result.ok());
  EXPECT_NEAR(result.value().poses[0].timestamp, 1403636580.838556, 1e-6);
}

TEST(TrajectoryFile, ReadsEuroc) {
  for (const char* header :
       {"#timestamp, p_RS_R_x [m]\n", "timestamp,px,py,pz,qw,qx,qy,qz\n", ""}) {
    const auto result =
        load(header + std::string("1403636580838555648,4.6,-1.7,0.7,0.5,0.5,0.5,0.5,"
                                  "-0.02,0.03,0.8,0,0,0,0,0,0\n"));
    ASSERT_TRUE(result.ok()) << result.error().message();
    EXPECT_EQ(result.value().format, TrajectoryFormat::euroc);
    const StampedPose& pose = result.value().poses.at(0);
    EXPECT_NEAR(pose.timestamp, 1403636580.838556, 1e-6);
    EXPECT_EQ(pose.T_world_cam.translation(), Vec3(4.6, -1.7, 0.7));
    EXPECT_DOUBLE_EQ(pose.T_world_cam.quaternion().w(), 0.5);
  }
}

TEST(TrajectoryFile, ReadsKitti) {
  const auto result = load("1 0 0 5 0 1 0 6 0 0 1 7\n0 -1 0 5 1 0 0 6 0 0 1 8.5e0\n");
  ASSERT_TRUE(result.ok()) << result.error().message();
  EXPECT_EQ(result.value().format, TrajectoryFormat::kitti);
  ASSERT_EQ(result.value().poses.size(), 2u);
  EXPECT_DOUBLE_EQ(result.value().poses[1].timestamp, 1);
  EXPECT_EQ(result.value().poses[1].T_world_cam.translation(), Vec3(5, 6, 8.5));
  EXPECT_LT((result.value().poses[1].T_world_cam * Vec3(1, 0, 0) - Vec3(5, 7, 8.5)).norm(), 1e-12);
}

TEST(TrajectoryFile, ErrorsNameTheLine) {
  const std::string good = "1 0 0 0 0 0 0 1\n";
  expectError("", "", "holds no pose");
  expectError("# only a comment\n\n", "", "holds no pose");
  expectError(good + "2 0 nan 0 0 0 0 1\n", ":2", "'nan' is not a finite number");
  expectError("nan 0 0 0 0 0 0 1\n", ":1", "'nan' is not a finite number");
  expectError("#\n" + good + "2 0 0 0 0 0 0 inf\n", ":3", "not a finite number");
  expectError(good + "2 0 0 x1 0 0 0 1\n", ":2", "'x1' is not a finite number");
  expectError(good + "2 0 0\n", ":2", "3 fields instead of 8");
  expectError(good + "1 0 0 0 0 1 0 0 0 0 1 0\n", ":2", "12 fields instead of 8");
  expectError("2 0 0\n", ":1", "3 columns are no known format");
  expectError("2 0 0 0 0 0 0 1\n" + good, ":2", "earlier");
  expectError("1 0 0 0 0 0 0 0\n", ":1", "quaternion is zero");
  expectError("1 0 0 0 0 0 0 3\n", ":1", "length 3");
  expectError("1 0 0 5 0 1 0 6 0 0 2 7\n", ":1", "not a rotation");
  expectError("-1 0 0 5 0 1 0 6 0 0 1 7\n", ":1", "not a rotation");
}

TEST(TrajectoryFile, RareRepeatedTimestampsWarnManyAreAnError) {
  std::string text;
  for (int i = 0; i < 20; ++i) text += std::to_string(i) + " 0 0 0 0 0 0 1\n";
  const auto result = load(text + "19 5 0 0 0 0 0 1\n");
  ASSERT_TRUE(result.ok()) << result.error().message();
  ASSERT_EQ(result.value().warnings.size(), 1u);
  EXPECT_NE(result.value().warnings[0].find(":21: 1 of 21"), std::string::npos);
  EXPECT_EQ(result.value().poses.size(), 20u);
  EXPECT_EQ(result.value().poses.back().T_world_cam.translation().x(), 0);
  expectError("1.3e9 0 0 0 0 0 0 1\n1.3e9 1 0 0 0 0 0 1\n", ":2", "1 of 2 timestamps repeat",
              TrajectoryUse::ground_truth);
}

TEST(TrajectoryFile, RepeatedTimestampsOfAnEstimateAreRefused) {
  const test::TemporaryFolder folder;
  std::string text;
  for (int i = 0; i < 20; ++i) text += std::to_string(i) + " 0 0 0 0 0 0 1\n";
  test::writeText(folder / "poses.txt", text + "19 5 0 0 0 0 0 1\n");
  const auto result = loadTrajectory(folder / "poses.txt", {TrajectoryUse::estimate});
  ASSERT_FALSE(result.ok());
  EXPECT_NE(result.error().message().find("poses.txt:21: the timestamp is that of the row above"),
            std::string::npos)
      << result.error().message();
}

TEST(TrajectoryFile, AGroundTruthMayHaveGaps) {
  std::string text =
      "\xEF\xBB\xBF# timestamp tx ty tz qx qy qz qw\r\n3 1 2 3 0 0 0.7071068 0.7071068\n";
  text += "1 nan 0 0 0 0 0 1\n2 1 0 0 nan 0 0 1\n";
  for (int i = 4; i < 10; ++i) text += std::to_string(i) + " 0 0 0 0 0 0 1\n";
  text += "2.5,+4,5,6,0,0,0,1.05\n";
  const auto result = load(text);
  ASSERT_TRUE(result.ok()) << result.error().message();
  EXPECT_EQ(result.value().skipped_rows, 2);
  ASSERT_EQ(result.value().warnings.size(), 2u);
  EXPECT_NE(result.value().warnings[0].find("2 of 10 rows are passed over"), std::string::npos);
  EXPECT_NE(result.value().warnings[1].find("sorted by time"), std::string::npos);
  ASSERT_EQ(result.value().poses.size(), 8u);
  EXPECT_EQ(result.value().poses[0].timestamp, 2.5);
  EXPECT_TRUE((result.value().poses[1].T_world_cam * Vec3(1, 0, 0)).isApprox(Vec3(1, 3, 3), 1e-6));
  expectError("1 nan 0 0 0 0 0 1\n", "", "no finite pose", TrajectoryUse::ground_truth);
  expectError("1 0 0 x 0 0 0 1\n", ":1", "'x' is not", TrajectoryUse::ground_truth);
}

TEST(TrajectoryFile, PositionsAlone) {
  for (const char* text :
       {"1 4 5 6\n2 4 5 7\n", "1000000000000000000,4,5,6\n1000000001000000000,4,5,7\n",
        "1 4 5 6 0 0 0 0\n2 4 5 7 0 0 0 0\n",
        "1 4 5 6 nan nan nan nan\n2 4 5 7 nan nan nan nan\n"}) {
    const auto result = load(text);
    ASSERT_TRUE(result.ok()) << result.error().message();
    EXPECT_TRUE(result.value().positions_only) << text;
    ASSERT_EQ(result.value().poses.size(), 2u);
    EXPECT_EQ(result.value().poses[1].T_world_cam.translation(), Vec3(4, 5, 7));
    EXPECT_NEAR(result.value().poses[1].timestamp - result.value().poses[0].timestamp, 1, 1e-6);
  }
}

TEST(TrajectoryFile, FurtherColumnsAndWholeMatrices) {
  const auto covariances = load("1 4 5 6 0 0 0 1 0.1 0.2 0.3\n2 4 5 7 0 0 0 1 0.1 0.2 0.3\n");
  ASSERT_TRUE(covariances.ok()) << covariances.error().message();
  EXPECT_EQ(covariances.value().format, TrajectoryFormat::tum);
  EXPECT_EQ(covariances.value().poses.size(), 2u);
  const auto matrix = load("1 0 0 5 0 1 0 6 0 0 1 7 0 0 0 1\n");
  ASSERT_TRUE(matrix.ok()) << matrix.error().message();
  EXPECT_EQ(matrix.value().format, TrajectoryFormat::kitti);
  EXPECT_EQ(matrix.value().poses[0].T_world_cam.translation(), Vec3(5, 6, 7));
}

TEST(TrajectoryFile, QuaternionsMayBeginWithW) {
  const test::TemporaryFolder folder;
  test::writeText(folder / "poses.txt", "1 0 0 0 0.6 0 0 0.8\n");
  TrajectoryReading reading;
  reading.quaternion = QuaternionOrder::wxyz;
  const auto result = loadTrajectory(folder / "poses.txt", reading);
  ASSERT_TRUE(result.ok());
  EXPECT_NEAR(result.value().poses[0].T_world_cam.quaternion().z(), 0.8, 1e-12);
}

TEST(TrajectoryFile, MissingFileAndFolderAreErrors) {
  const test::TemporaryFolder folder;
  EXPECT_FALSE(loadTrajectory(folder / "absent.txt").ok());
  EXPECT_FALSE(loadTrajectory(folder.path()).ok());
}

TEST(TrajectoryFile, BinaryGarbageIsAnError) {
  std::string garbage;
  for (int i = 0; i < 4096; ++i) garbage.push_back(static_cast<char>(i * 37 % 251));
  EXPECT_FALSE(load(garbage).ok());
}

}  // namespace
}  // namespace svoscope
