// SPDX-License-Identifier: MIT
#include "engine/base/quantile.h"

#include <gtest/gtest.h>

namespace svoscope {
namespace {

TEST(Quantile, IsOneOfTheValues) {
  EXPECT_EQ(quantile({4, 1, 3, 2}, 0.5), 2);
  EXPECT_EQ(quantile({4, 1, 3, 2}, 1), 4);
  EXPECT_EQ(quantile({}, 0.5), 0);
}

TEST(Quantile, InterpolatesBetweenNeighbours) {
  EXPECT_DOUBLE_EQ(interpolatedQuantile({4, 1, 3, 2}, 0.5).value(), 2.5);
  EXPECT_DOUBLE_EQ(interpolatedQuantile({1, 2, 3}, 0.95).value(), 2.9);
  EXPECT_DOUBLE_EQ(interpolatedQuantile({7}, 0.95).value(), 7);
  EXPECT_FALSE(interpolatedQuantile({}, 0.5));
}

TEST(Quantile, TheUpperOfTwoMiddleValuesIsTheMedian) {
  EXPECT_EQ(upperMedian({4, 1, 3, 2}), 3);
  EXPECT_EQ(upperMedian({5, 1, 9}), 5);
  EXPECT_EQ(upperMedian({}), 0);
}

}  // namespace
}  // namespace svoscope
