// SPDX-License-Identifier: MIT
#include "engine/eval/delta.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace svoscope {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

/// Poses along x at the given times (s) and positions (m).
Trajectory along(const std::vector<double>& times, const std::vector<double>& x) {
  Trajectory poses;
  for (std::size_t i = 0; i < times.size(); ++i) {
    poses.push_back({times[i], SE3(Eigen::Quaterniond::Identity(), Vec3(x[i], 0, 0))});
  }
  return poses;
}

TEST(Delta, IsParsedAndPrinted) {
  for (const char* text : {"1s", "0.5s", "30f", "10m", "2.5m"}) {
    ASSERT_TRUE(parseDelta(text).ok()) << text;
    EXPECT_EQ(parseDelta(text).value().text(), text);
  }
  for (const char* text :
       {"", "s", "1", "1x", "-1s", "0f", "1.5f", "nans", "1 s", "1e99m", "infm"}) {
    ASSERT_FALSE(parseDelta(text).ok()) << text;
    EXPECT_EQ(parseDelta(text).error().kind, ErrorKind::usage);
  }
}

TEST(Delta, FramesConsecutiveAndAll) {
  const Trajectory poses = along({0, 1, 2, 3, 4}, {0, 0, 0, 0, 0});
  const Delta two{2, Delta::Unit::frames};
  EXPECT_THAT(pairsApart(poses, two, false), ElementsAre(Pair(0, 2), Pair(2, 4)));
  EXPECT_THAT(pairsApart(poses, two, true), ElementsAre(Pair(0, 2), Pair(1, 3), Pair(2, 4)));
  EXPECT_THAT(pairsApart({}, two, false), IsEmpty());
}

TEST(Delta, MetresFollowThePath) {
  // Back and forth: 1 m of path per pose.
  const Trajectory poses = along({0, 1, 2, 3, 4, 5, 6}, {0, 1, 0, 1, 0, 1, 0});
  const Delta two{2, Delta::Unit::metres};
  EXPECT_THAT(pairsApart(poses, two, false), ElementsAre(Pair(2, 4), Pair(4, 6)));
  EXPECT_THAT(pairsApart(poses, two, true),
              ElementsAre(Pair(0, 2), Pair(1, 3), Pair(2, 4), Pair(3, 5), Pair(4, 6)));
  EXPECT_THAT(pairsApart(poses, {100, Delta::Unit::metres}, false), IsEmpty());
}

TEST(Delta, SecondsDoNotBridgeGaps) {
  const Trajectory poses = along({0, 0.5, 1.01, 5, 5.5, 6}, {0, 0, 0, 0, 0, 0});
  const Delta one{1, Delta::Unit::seconds};
  EXPECT_THAT(pairsApart(poses, one, false), ElementsAre(Pair(0, 2), Pair(3, 5)));
  EXPECT_THAT(pairsApart(poses, {0.5, Delta::Unit::seconds}, true),
              ElementsAre(Pair(0, 1), Pair(1, 2), Pair(3, 4), Pair(4, 5)));
}

}  // namespace
}  // namespace svoscope
