// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "engine/eval/trajectory_file.h"
#include "engine/io/frames_csv.h"
#include "engine/io/map_ply.h"
#include "engine/io/png.h"
#include "engine/io/text_output.h"
#include "engine/io/trajectory_writer.h"
#include "tests/support/scripted_runner.h"
#include "tests/support/support.h"

namespace svoscope {
namespace {

namespace fs = std::filesystem;

Trajectory someTrajectory() {
  Trajectory poses;
  for (int i = 0; i < 5; ++i) {
    poses.push_back({1403636579.763555 + 0.05 * i,
                     SE3(so3Exp(Vec3(0.1 * i, -0.2, 0.3)), Vec3(1.0 / 3 * i, -2, 1e-7))});
  }
  return poses;
}

void expectSame(const Trajectory& a, const Trajectory& b, bool times) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (times) {
      EXPECT_NEAR(a[i].timestamp, b[i].timestamp, 1e-6);
    }
    EXPECT_LT((a[i].T_world_cam.matrix() - b[i].T_world_cam.matrix()).norm(), 1e-7);
  }
}

TEST(TrajectoryWriter, WhatIsWrittenIsReadBack) {
  const test::TemporaryFolder folder;
  const Trajectory poses = someTrajectory();
  ASSERT_TRUE(writeTumTrajectory(folder / "tum.txt", poses).ok());
  ASSERT_TRUE(writeEurocTrajectory(folder / "euroc.csv", poses).ok());
  ASSERT_TRUE(writeKittiTrajectory(folder / "kitti.txt", poses).ok());
  const auto tum = loadTrajectory(folder / "tum.txt");
  const auto euroc = loadTrajectory(folder / "euroc.csv");
  const auto kitti = loadTrajectory(folder / "kitti.txt");
  ASSERT_TRUE(tum.ok() && euroc.ok() && kitti.ok());
  EXPECT_EQ(tum.value().format, TrajectoryFormat::tum);
  EXPECT_EQ(euroc.value().format, TrajectoryFormat::euroc);
  EXPECT_EQ(kitti.value().format, TrajectoryFormat::kitti);
  expectSame(tum.value().poses, poses, true);
  expectSame(euroc.value().poses, poses, true);
  expectSame(kitti.value().poses, poses, false);
}

TEST(TrajectoryWriter, LinesHaveFixedPrecision) {
  const SE3 T(Eigen::Quaterniond::Identity(), Vec3(1.0 / 3, -2, 0));
  EXPECT_EQ(tumLine({1.5, T}), "1.500000 0.333333333 -2 0 0 0 0 1");
}

TEST(TextOutput, WholeFilesLeaveNoTemporaryBehind) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(writeWhole(folder / "a.txt", "one").ok());
  ASSERT_TRUE(writeWhole(folder / "a.txt", "two").ok());
  EXPECT_EQ(test::readText(folder / "a.txt"), "two");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

TEST(TextOutput, UnwritablePlacesAreOutputErrors) {
  const test::TemporaryFolder folder;
  test::writeText(folder / "file", "");
  const Status missing = writeWhole(folder / "absent" / "a.txt", "x");
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().exitCode(), 4);
  EXPECT_NE(missing.error().message().find("No such file"), std::string::npos);
  EXPECT_FALSE(makeFolder(folder / "file").ok());
  EXPECT_FALSE(makeFolder(folder / "file" / "below").ok());
  LineFile lines;
  EXPECT_FALSE(lines.open(folder / "absent" / "b.txt").ok());
}

TEST(TextOutput, AFullDiskIsNoticed) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  LineFile lines;
  ASSERT_TRUE(lines.open("/dev/full").ok());
  const Status status = lines.write("x");
  ASSERT_FALSE(status.ok());
  EXPECT_NE(status.error().what.find("No space"), std::string::npos);
}

TEST(TextOutput, AFileThatCannotGrowEndsWithAWholeLine) {
  const test::TemporaryFolder folder;
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{1000, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &limit);
  LineFile lines;
  ASSERT_TRUE(lines.open(folder / "t.txt").ok());
  int written = 0;
  while (written < 100 && lines.write("a line of twenty-six bytes").ok()) ++written;
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(written, 37);  // 27 bytes each
  EXPECT_EQ(fs::file_size(folder / "t.txt"), 37u * 27u);
}

/// Fields of a CSV row; commas inside quotes do not count.
std::size_t fields(const std::string& row) {
  bool quoted = false;
  std::size_t commas = 0;
  for (const char c : row) {
    if (c == '"') quoted = !quoted;
    if (c == ',' && !quoted) ++commas;
  }
  return commas + 1;
}

TEST(FramesCsv, RowsFitTheHeader) {
  const std::string header = framesCsvHeader();
  EXPECT_EQ(header.substr(0, 21), "index,timestamp,state");
  for (const FrameRecord& record : test::fakeRecords(13)) {
    const std::string row = framesCsvRow(record);
    EXPECT_EQ(fields(row), fields(header)) << row;
    EXPECT_EQ(row.find('\n'), std::string::npos);
  }
  const std::string lost = framesCsvRow(test::fakeRecords(13)[10]);
  EXPECT_NE(lost.find("\"3 inliers < 40 required\",\"\",,,,,,,,"), std::string::npos) << lost;
  EXPECT_NE(framesCsvRow(test::fakeRecords(3)[2]).find("\"tracking, \"\"good\"\"\""),
            std::string::npos);
}

TEST(FramesCsv, EveryStageHasAColumn) {
  const std::string header = framesCsvHeader();
  for (int i = 0; i < kStageCount; ++i) {
    const std::string name = std::string("ms_") + stageName(static_cast<Stage>(i));
    EXPECT_NE(header.find(name), std::string::npos) << name;
  }
}

TEST(MapPly, CountsAndColumns) {
  const test::TemporaryFolder folder;
  const auto snapshot = test::fakeSnapshot({});
  ASSERT_TRUE(writeMapPly(folder / "map.ply", *snapshot->points, "js").ok());
  const std::string text = test::readText(folder / "map.ply");
  EXPECT_EQ(text.substr(0, 4), "ply\n");
  EXPECT_NE(text.find("element vertex 5\n"), std::string::npos);
  EXPECT_NE(text.find("comment seed rule js\n"), std::string::npos);
  EXPECT_NE(text.find("\nend_header\n0 -1 4 0 0 0 -1\n1.5 -1 4 0 1 0 -1\n"), std::string::npos);
  EXPECT_NE(text.find("\n4.5 -1 4 0 3 2 -1\n6 -1 4 0 3 2 -1\n"), std::string::npos);
  EXPECT_TRUE(writeMapPly(folder / "empty.ply", {}, "kl").ok());
}

TEST(Png, IsReadBackAndErrorsAreNoticed) {
  const test::TemporaryFolder folder;
  cv::Mat image(4, 6, CV_8UC3, cv::Scalar(1, 2, 3));
  ASSERT_TRUE(writePng(folder / "a.png", image).ok());
  const cv::Mat back = cv::imread((folder / "a.png").string(), cv::IMREAD_UNCHANGED);
  ASSERT_EQ(back.size(), image.size());
  EXPECT_EQ(back.at<cv::Vec3b>(2, 3), cv::Vec3b(1, 2, 3));
  EXPECT_EQ(writePng(folder / "absent" / "a.png", image).error().exitCode(), 4);
  EXPECT_FALSE(writePng(folder / "b.png", cv::Mat()).ok());
}

}  // namespace
}  // namespace svoscope
