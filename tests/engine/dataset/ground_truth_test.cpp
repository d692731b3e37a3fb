// SPDX-License-Identifier: MIT
#include "engine/dataset/ground_truth.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/support.h"

namespace svoscope {
namespace {

using test::TemporaryFolder;
using test::writeText;
using ::testing::HasSubstr;

TEST(GroundTruth, TumTrajectoryIsSortedAndCommentsAreSkipped) {
  TemporaryFolder folder;
  const auto file = folder / "groundtruth.txt";
  writeText(file,
            "\xEF\xBB\xBF# timestamp tx ty tz qx qy qz qw\r\n"
            "2.5 1 2 3 0 0 0.7071068 0.7071068  # turned\r\n"
            "\r\n"
            "1.5,+4,5,6,0,0,0,2\n");
  const auto read = readTumTrajectory(file);
  ASSERT_TRUE(read.ok()) << read.error().message();
  const Trajectory& t = read.value();
  ASSERT_EQ(t.size(), 2u);
  EXPECT_EQ(t[0].timestamp, 1.5);
  EXPECT_TRUE(t[0].T_world_cam.rotation().isIdentity(1e-12)) << "quaternions are normalised";
  EXPECT_TRUE(t[1].T_world_cam.translation().isApprox(Vec3(1, 2, 3)));
  EXPECT_TRUE((t[1].T_world_cam * Vec3(1, 0, 0)).isApprox(Vec3(1, 3, 3), 1e-6));
}

TEST(GroundTruth, EurocTimesKeepTheirMicroseconds) {
  TemporaryFolder folder;
  const auto file = folder / "data.csv";
  writeText(file,
            "#timestamp, p_x [m], p_y, p_z, q_w, q_x, q_y, q_z, v_x\n"
            "1403636579763555584,1,2,3,0.7071068,0,0,0.7071068,9\n");
  const auto read = readEurocTrajectory(file);
  ASSERT_TRUE(read.ok()) << read.error().message();
  EXPECT_NEAR(read.value()[0].timestamp - 1403636579.0, 0.763555584, 1e-6);
  EXPECT_TRUE((read.value()[0].T_world_cam * Vec3(1, 0, 0)).isApprox(Vec3(1, 3, 3), 1e-6));
}

TEST(GroundTruth, KittiRowsAreMatrices) {
  TemporaryFolder folder;
  const auto file = folder / "00.txt";
  writeText(file, "1 0 0 0 0 1 0 0 0 0 1 0\n0 0 1 4 0 1 0 5 -1 0 0 6\n");
  const auto read = readKittiPoses(file);
  ASSERT_TRUE(read.ok()) << read.error().message();
  ASSERT_EQ(read.value().size(), 2u);
  EXPECT_TRUE((read.value()[1] * Vec3(1, 0, 0)).isApprox(Vec3(4, 5, 5), 1e-9));
}

TEST(GroundTruth, DamageIsReportedWithFileAndLine) {
  TemporaryFolder folder;
  const auto file = folder / "bad.txt";
  const auto tum = [&](const std::string& text) {
    writeText(file, text);
    const auto read = readTumTrajectory(file);
    return read.ok() ? std::string("accepted") : read.error().message();
  };
  EXPECT_THAT(tum("1 0 0 0 0 0 0 0\n"), HasSubstr("bad.txt:1: the quaternion has norm zero"));
  EXPECT_THAT(tum("1 0 0 0 0 0 0 1\n2 nan 0 0 0 0 0 1\n"), HasSubstr("bad.txt:2: 'nan'"));
  EXPECT_THAT(tum("1 0 0\n"), HasSubstr("3 fields instead of 8"));
  EXPECT_THAT(tum("1 0 0 x 0 0 0 1\n"), HasSubstr("'x' is not a finite number"));
  EXPECT_THAT(tum("# nothing\n"), HasSubstr("the file holds no pose"));
  EXPECT_THAT(readTumTrajectory(folder / "none.txt").error().message(),
              HasSubstr("none.txt is missing"));
  writeText(file, "1 0 0 0 0 1 0 0 0 0 2 0\n");
  EXPECT_THAT(readKittiPoses(file).error().message(), HasSubstr("not a rotation"));
  writeText(file, "1.5,0,0,0,1,0,0,0\n");
  EXPECT_THAT(readEurocTrajectory(file).error().message(), HasSubstr("whole nanoseconds"));
  EXPECT_EQ(readEurocTrajectory(file).error().kind, ErrorKind::input);
}

}  // namespace
}  // namespace svoscope
