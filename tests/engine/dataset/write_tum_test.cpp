// SPDX-License-Identifier: MIT
#include "engine/dataset/write_tum.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "tests/engine/dataset/tiny_sequence.h"

namespace svoscope {
namespace {

using namespace test;

TEST(WriteTum, WhatIsWrittenReadsBackTheSame) {
  TemporaryFolder folder;
  auto source = openSequence("synthetic:desk?size=80x60&frames=4");
  ASSERT_TRUE(source.ok());
  Sequence& a = *source.value();
  int calls = 0;
  const Status written = writeTumSequence(a, folder / "out", [&](int done, int total) {
    EXPECT_EQ(done, ++calls);
    EXPECT_EQ(total, 4);
    return true;
  });
  ASSERT_TRUE(written.ok()) << written.error().message();
  auto read = openSequence((folder / "out").string());
  ASSERT_TRUE(read.ok()) << read.error().message();
  Sequence& b = *read.value();
  ASSERT_EQ(b.size(), 4);
  EXPECT_EQ(b.camera().pinhole.fx, a.camera().pinhole.fx);
  EXPECT_EQ(b.camera().rate_hz, 30);
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(b.timestamp(i), a.timestamp(i), 1e-6);
    EXPECT_EQ(cv::norm(a.read(i).value().gray, b.read(i).value().gray, cv::NORM_INF), 0);
    EXPECT_LT(cv::norm(a.readDepth(i).value(), b.readDepth(i).value(), cv::NORM_INF), 1.1e-4);
    const SE3 delta = a.groundTruth()[i].T_world_cam.inverse() * b.groundTruth()[i].T_world_cam;
    EXPECT_LT(delta.log().norm(), 1e-7);
  }
}

TEST(WriteTum, StoppingLeavesAShorterSequence) {
  TemporaryFolder folder;
  auto source = openSequence("synthetic:desk?size=64x48&frames=5");
  ASSERT_TRUE(source.ok());
  const auto twice = [](int done, int) { return done < 2; };
  ASSERT_TRUE(writeTumSequence(*source.value(), folder.path(), twice).ok());
  auto read = openSequence(folder.path().string());
  ASSERT_TRUE(read.ok()) << read.error().message();
  EXPECT_EQ(read.value()->size(), 2);
}

TEST(WriteTum, WithoutDepthThereIsNoDepthFolder) {
  TemporaryFolder folder;
  writeTinyTum(folder / "in");
  std::filesystem::remove(folder / "in/depth.txt");
  auto source = openSequence((folder / "in").string());
  ASSERT_TRUE(source.ok());
  ASSERT_TRUE(writeTumSequence(*source.value(), folder / "out", {}).ok());
  EXPECT_FALSE(std::filesystem::exists(folder / "out/depth.txt"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out/depth"));
}

TEST(WriteTum, UnwritableFolderIsAnOutputError) {
  TemporaryFolder folder;
  writeText(folder / "file", "in the way");
  auto source = openSequence("synthetic:desk?size=64x48&frames=1");
  ASSERT_TRUE(source.ok());
  const Status status = writeTumSequence(*source.value(), folder / "file/out", {});
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().kind, ErrorKind::output);
  EXPECT_THAT(status.error().message(), ::testing::HasSubstr("file/out"));
}

}  // namespace
}  // namespace svoscope
