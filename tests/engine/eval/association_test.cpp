// SPDX-License-Identifier: MIT
#include "engine/eval/association.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace svoscope {
namespace {

Trajectory at(std::initializer_list<double> times) {
  Trajectory result;
  for (const double t : times) result.push_back({t, SE3()});
  return result;
}

TEST(Association, TakesTheNearestWithinTheLimit) {
  const auto pairs = associateByTime(at({0, 0.1, 0.2, 0.3}), at({0.101, 0.219, 0.35}), 0.02);
  ASSERT_TRUE(pairs.ok());
  ASSERT_EQ(pairs.value().size(), 2u);
  EXPECT_EQ(pairs.value()[0].gt, 1);
  EXPECT_EQ(pairs.value()[0].est, 0);
  EXPECT_EQ(pairs.value()[1].gt, 2);
  EXPECT_EQ(pairs.value()[1].est, 1);
}

TEST(Association, WorksFromTheShorterTrajectory) {
  // One pose of ground truth, two of the estimate nearby: one pair, not two.
  const auto pairs = associateByTime(at({0.1}), at({0.09, 0.105}), 0.02);
  ASSERT_TRUE(pairs.ok());
  ASSERT_EQ(pairs.value().size(), 1u);
  EXPECT_EQ(pairs.value()[0].est, 1);
  // The other way round a pose of the longer one may serve twice.
  EXPECT_EQ(associateByTime(at({0.1, 5, 6}), at({0.09, 0.105}), 0.02).value().size(), 2u);
}

TEST(Association, BeforeAndAfterTheOtherTrajectory) {
  EXPECT_EQ(associateByTime(at({1, 2}), at({0.99, 2.01}), 0.02).value().size(), 2u);
  EXPECT_FALSE(associateByTime(at({1, 2}), at({0.5, 2.5}), 0.02).ok());
}

TEST(Association, ByRowNeedsAsManyRows) {
  EXPECT_EQ(associateByRow(at({0, 1}), at({0, 1})).value().size(), 2u);
  const auto wrong = associateByRow(at({0, 1}), at({0}));
  ASSERT_FALSE(wrong.ok());
  EXPECT_EQ(wrong.error().what, "2 rows of ground truth, 1 of the estimate");
}

}  // namespace
}  // namespace svoscope
