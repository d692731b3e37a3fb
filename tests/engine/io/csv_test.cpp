// SPDX-License-Identifier: MIT
#include "engine/io/csv.h"

#include <gtest/gtest.h>

namespace svoscope {
namespace {

TEST(Csv, AMissingNumberIsAnEmptyField) {
  EXPECT_EQ(csvNumber(std::nullopt), "");
  EXPECT_EQ(csvNumber(0.0), "0");
  EXPECT_EQ(csvNumber(1.0 / 3), "0.333333");
}

TEST(Csv, TextsAreQuotedWhereTheyMust) {
  EXPECT_EQ(csvText("room"), "room");
  EXPECT_EQ(csvText("a,b"), "\"a,b\"");
  EXPECT_EQ(csvText("two\nlines"), "\"two\nlines\"");
  EXPECT_EQ(csvText("say \"no\""), "\"say \"\"no\"\"\"");
  EXPECT_EQ(csvQuoted("room"), "\"room\"");
}

}  // namespace
}  // namespace svoscope
