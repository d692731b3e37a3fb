// SPDX-License-Identifier: MIT
#include "engine/tracking/start.h"

#include <gtest/gtest.h>

#include "engine/dataset/sequence.h"
#include "tests/support/memory_sequence.h"

namespace svoscope {
namespace {

constexpr const char* kRoom = "synthetic:room?size=320x240&frames=60";

Frame frameOf(Sequence& sequence, int i) {
  const SequenceImage image = sequence.read(i).value();
  Frame f;
  f.index = i;
  f.timestamp = image.timestamp;
  f.pyramid = buildPyramid(image.gray, pyramidLevels(image.gray.cols));
  return f;
}

TEST(Start, KeepsWhatTheLastFrameShowed) {
  const auto sequence = test::openBuiltIn(kRoom);
  Start start(sequence->camera().pinhole, {});
  EXPECT_EQ(start.output().reference_index, -1);
  int i = 0;
  while (i < 50 && !start.process(frameOf(*sequence, i)).initialized) {
    EXPECT_FALSE(start.output().reason.empty());
    ++i;
  }
  ASSERT_LT(i, 50);
  EXPECT_TRUE(start.output().initialized);
  EXPECT_EQ(start.output().poses.back().frame_index, i);
  EXPECT_GT(startVelocity(start.output()).translation().norm(), 0);
}

TEST(Start, BesideItLooksForAnotherWithoutTouchingTheFirst) {
  const auto sequence = test::openBuiltIn(kRoom);
  Start start(sequence->camera().pinhole, {}), alone(sequence->camera().pinhole, {});
  InitializerOutput kept;
  kept.reason = "the first";
  start.keep(kept);
  int i = 0, first = -1, again = -1;
  for (; i < 50 && first < 0; ++i) {
    if (start.processBeside(frameOf(*sequence, i), {})) first = i;
  }
  for (i = 0; i < 50 && again < 0; ++i) {
    if (alone.process(frameOf(*sequence, i)).initialized) again = i;
  }
  ASSERT_GE(first, 0);
  EXPECT_EQ(first, again) << "the same start as in the foreground";
  EXPECT_EQ(start.output().reason, "the first");
}

TEST(Start, BesideBeginsAnewOnceStopped) {
  const auto sequence = test::openBuiltIn(kRoom);
  Start start(sequence->camera().pinhole, {});
  int i = 0;
  while (i < 50 && !start.process(frameOf(*sequence, i)).initialized) ++i;
  ASSERT_LT(i, 50);
  for (int k = 0; k < i; ++k)
    ASSERT_FALSE(start.processBeside(frameOf(*sequence, k), {}).has_value()) << k;
  start.stopBeside();
  EXPECT_FALSE(start.processBeside(frameOf(*sequence, i), {}).has_value())
      << "its references are forgotten";
}

TEST(Start, VelocityNeedsTwoFramesInARow) {
  InitializerOutput output;
  EXPECT_EQ(startVelocity(output).matrix(), SE3().matrix());
  const auto at = [](double x) { return SE3(Eigen::Quaterniond::Identity(), Vec3(x, 0, 0)); };
  output.poses = {{3, 0.0, SE3()}, {6, 0.1, at(0.3)}, {7, 0.2, at(0.4)}};
  EXPECT_NEAR(startVelocity(output).translation().x(), 0.1, 1e-12);
  output.poses.pop_back();
  EXPECT_EQ(startVelocity(output).matrix(), SE3().matrix()) << "frames 3 and 6";
}

}  // namespace
}  // namespace svoscope
