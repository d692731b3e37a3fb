// SPDX-License-Identifier: MIT
#include "engine/base/stamps.h"

#include <gtest/gtest.h>

namespace svoscope {
namespace {

TEST(Stamps, UnitByMagnitude) {
  for (const auto& [fields, unit] : std::vector<std::pair<std::vector<std::string>, StampUnit>>{
           {{"1403715273.262", "1403715273.312"}, StampUnit::seconds},
           {{"1403715273262", "1403715273312"}, StampUnit::milliseconds},
           {{"1403715273262142", "1403715273312143"}, StampUnit::microseconds},
           {{"1403715273262142976", "1403715273312143104"}, StampUnit::nanoseconds}}) {
    const auto stamps = readStamps(fields);
    ASSERT_TRUE(stamps.has_value());
    EXPECT_EQ(stamps->unit, unit) << fields[0];
    EXPECT_NEAR(stamps->seconds[0], 1403715273.262, 2e-3);
    EXPECT_NEAR(stamps->seconds[1] - stamps->seconds[0], 0.05, 1e-5);
  }
}

TEST(Stamps, NanosecondsKeepTheirDigits) {
  const auto stamps = readStamps({"1403715273262142976", "1403715273282142976"});
  ASSERT_TRUE(stamps.has_value());
  // One double ulp at this size is 2.4e-7 s.
  EXPECT_NEAR(stamps->seconds[1] - stamps->seconds[0], 0.02, 5e-7);
}

TEST(Stamps, ClockSinceTheMachineStarted) {
  // Five hours in nanoseconds look like milliseconds since 1970, until two images are 33000 s
  // apart.
  const auto stamps = readStamps({"18000000000000", "18000033333333", "18000066666666"});
  ASSERT_TRUE(stamps.has_value());
  EXPECT_EQ(stamps->unit, StampUnit::nanoseconds);
  EXPECT_NEAR(stamps->seconds[2], 18000.066666666, 1e-9);
}

TEST(Stamps, SmallNumbersAreSeconds) {
  const auto stamps = readStamps({"0", "1", "2"});
  ASSERT_TRUE(stamps.has_value());
  EXPECT_EQ(stamps->unit, StampUnit::seconds);
  EXPECT_EQ(stamps->seconds[2], 2);
}

TEST(Stamps, WhatIsNoNumberIsNamed) {
  std::size_t bad = 99;
  EXPECT_FALSE(readStamps({"1.0", "nan", "x"}, &bad).has_value());
  EXPECT_EQ(bad, 1u);
}

TEST(Stamps, FileNames) {
  EXPECT_TRUE(stampsOfNames({"1403715273262142976", "1403715273312143104"}).has_value());
  EXPECT_TRUE(stampsOfNames({"1305031102.175304", "1305031102.211214"}).has_value());
  EXPECT_FALSE(stampsOfNames({"000000", "000001"}).has_value()) << "counters";
  EXPECT_FALSE(stampsOfNames({"frame1", "frame2"}).has_value());
  EXPECT_FALSE(stampsOfNames({"1403715273262142976", "1403715273262142976"}).has_value());
  EXPECT_FALSE(stampsOfNames({}).has_value());
}

}  // namespace
}  // namespace svoscope
