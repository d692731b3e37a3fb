// SPDX-License-Identifier: MIT
#include "engine/eval/bootstrap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace svoscope {
namespace {

std::vector<double> normal(std::mt19937_64& random, int count, double mean, double sigma) {
  std::normal_distribution<double> distribution(mean, sigma);
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(distribution(random));
  return values;
}

TEST(Bootstrap, TheIntervalOfAMeanIsThatOfTheNormalDistribution) {
  std::mt19937_64 random(3);
  const std::vector<double> values = normal(random, 200, 5, 2);
  const double mean = meanOf(values);
  double squares = 0;
  for (const double v : values) squares += (v - mean) * (v - mean);
  const double half = 1.96 * std::sqrt(squares / 200 / 200);
  const Interval interval = bootstrapMean(values);
  EXPECT_NEAR(interval.low, mean - half, 0.06 * half);
  EXPECT_NEAR(interval.high, mean + half, 0.06 * half);
}

/// Share of `trials` in which the interval of `count` normal values holds their mean.
double coverage(std::uint64_t seed, int count, int trials, int resamples) {
  std::mt19937_64 random(seed);
  BootstrapOptions options;
  options.resamples = resamples;
  int covered = 0;
  for (int i = 0; i < trials; ++i) {
    options.seed = static_cast<std::uint64_t>(i);
    const Interval interval = bootstrapMean(normal(random, count, 1, 1), options);
    covered += interval.low <= 1 && 1 <= interval.high;
  }
  return covered / static_cast<double>(trials);
}

TEST(Bootstrap, TheIntervalCoversTheTruthAsOftenAsItSays) {
  const double covered = coverage(4, 30, 400, 500);
  EXPECT_GT(covered, 0.89);  // 95 % +- 3 sigma of 400 trials, and a little
  EXPECT_LT(covered, 0.985);
}

TEST(Bootstrap, TheIntervalOfSixValuesCoversTheTruthToo) {
  const double covered = coverage(8, 6, 600, 2000);
  EXPECT_GT(covered, 0.92);  // unexpanded: 0.87
  EXPECT_LT(covered, 0.98);
}

TEST(StudentQuantile, HasTheValuesOfTheTables) {
  EXPECT_NEAR(studentQuantile(0.975, 1), 12.706, 1e-3);
  EXPECT_NEAR(studentQuantile(0.975, 5), 2.5706, 1e-4);
  EXPECT_NEAR(studentQuantile(0.95, 10), 1.8125, 1e-4);
  EXPECT_NEAR(studentQuantile(0.975, 1000), 1.9623, 1e-4);
}

TEST(Bootstrap, TheSameSeedGivesTheSameInterval) {
  std::mt19937_64 random(5);
  const std::vector<double> values = normal(random, 12, 0, 1);
  EXPECT_EQ(bootstrapMean(values).low, bootstrapMean(values).low);
  BootstrapOptions other;
  other.seed = 2;
  EXPECT_NE(bootstrapMean(values).low, bootstrapMean(values, other).low);
}

TEST(Bootstrap, FewValues) {
  EXPECT_EQ(bootstrapMean({}).high, 0);
  EXPECT_EQ(bootstrapMean({7}).low, 7);
  EXPECT_EQ(bootstrapMean({7}).high, 7);
  EXPECT_EQ(bootstrapPaired({}).groups, 0);
}

TEST(BootstrapPaired, RecoversAKnownDifferenceAcrossSequencesOfUnlikeSize) {
  std::mt19937_64 random(6);
  std::vector<PairedGroup> groups;
  for (int s = 0; s < 40; ++s) {
    const double level = 0.5 * s;  // what sequences differ by cancels
    groups.push_back({normal(random, 5, level - 0.3, 0.1), normal(random, 5, level, 0.1)});
  }
  const PairedDifference d = bootstrapPaired(groups);
  EXPECT_EQ(d.groups, 40);
  EXPECT_NEAR(d.mean, -0.3, 0.05);
  EXPECT_LT(d.interval.low, -0.3);
  EXPECT_GT(d.interval.high, -0.3);
  EXPECT_LT(d.interval.high - d.interval.low, 0.1);
}

TEST(BootstrapPaired, TheSpreadOfRunsWidensTheInterval) {
  const std::vector<PairedGroup> steady(8, PairedGroup{{1, 1, 1}, {0, 0, 0}});
  const std::vector<PairedGroup> spread(8, PairedGroup{{0, 1, 2}, {-1, 0, 1}});
  EXPECT_EQ(bootstrapPaired(steady).interval.high - bootstrapPaired(steady).interval.low, 0);
  EXPECT_NEAR(bootstrapPaired(spread).mean, 1, 1e-12);
  EXPECT_GT(bootstrapPaired(spread).interval.high - bootstrapPaired(spread).interval.low, 0.3);
}

}  // namespace
}  // namespace svoscope
