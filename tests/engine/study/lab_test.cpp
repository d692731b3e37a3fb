// SPDX-License-Identifier: MIT
#include "engine/study/lab.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/study/rule_variants.h"

namespace svoscope {
namespace {

struct Expected {
  const char* rule;
  double updates, error, wrong_80, wrong_60;
};

// 4000 seeds each, one draw of the random numbers. Over 40 draws the wrong fractions scatter with a
// standard deviation of 0.005 (both recalls); a difference of two draws by 3 * 0.005 * sqrt(2) =
// 0.021.
constexpr Expected kTable[] = {{"KL", 17, 0.0040, 0.054, 0.027},
                               {"JS fuse only", 13, 0.0049, 0.077, 0.052},
                               {"JS weight only", 17, 0.0038, 0.035, 0.013},
                               {"JS both", 13, 0.0047, 0.055, 0.029}};

TEST(Lab, ReproducesTheTableOfTheRules) {
  const LabResult result = runLab({});
  ASSERT_EQ(result.rows.size(), ruleVariants().size());
  for (int i = 0; i < 4; ++i) {
    const LabRow& row = result.rows[static_cast<std::size_t>(i)];
    const Expected& e = kTable[i];
    EXPECT_EQ(row.rule, e.rule);
    ASSERT_TRUE(row.median_updates && row.median_relative_error && row.wrong_at_80 &&
                row.wrong_at_60);
    EXPECT_NEAR(*row.median_updates, e.updates, 1);
    EXPECT_NEAR(*row.median_relative_error, e.error, 3e-4);
    EXPECT_NEAR(*row.wrong_at_80, e.wrong_80, 0.021);
    EXPECT_NEAR(*row.wrong_at_60, e.wrong_60, 0.021);
  }
  // What separates the terms is far above the scatter, since all rules see the same numbers.
  const auto& r = result.rows;
  EXPECT_GT(*r[1].wrong_at_80, *r[0].wrong_at_80);
  EXPECT_LT(*r[2].wrong_at_80, *r[0].wrong_at_80);
  EXPECT_LT(*r[3].median_updates, *r[0].median_updates);
}

TEST(Lab, IsDeterministic) {
  LabOptions o;
  o.seeds = 200;
  const LabResult a = runLab(o), b = runLab(o);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(a.rows[i].median_relative_error, b.rows[i].median_relative_error);
  o.random_seed = 1;
  EXPECT_NE(a.rows[0].median_relative_error, runLab(o).rows[0].median_relative_error);
}

TEST(Lab, CurvesFall) {
  LabOptions o;
  o.seeds = 300;
  for (const LabRow& row : runLab(o).rows) {
    ASSERT_EQ(row.curve.size(), 60u);
    EXPECT_LT(row.curve.back().median_error, 0.1 * row.curve.front().median_error);
    EXPECT_GT(row.curve.back().converged, 0.9);
    for (std::size_t i = 1; i < row.curve.size(); ++i)
      EXPECT_GE(row.curve[i].converged, row.curve[i - 1].converged);
  }
}

TEST(Lab, ImpossiblePopulationsGiveNoFigures) {
  LabOptions o;
  o.seeds = 50;
  o.updates = 20;
  o.hopeless = 1;
  for (const LabRow& row : runLab(o).rows) {
    EXPECT_FALSE(row.median_updates);
    EXPECT_FALSE(row.wrong_at_80);
    EXPECT_TRUE(row.sweep.empty());
    for (const LabCurvePoint& p : row.curve)
      EXPECT_TRUE(std::isfinite(p.median_error) && std::isfinite(p.median_sigma));
  }
  o.seeds = 0;
  EXPECT_NE(o.check(), "");
  EXPECT_TRUE(runLab(o).rows.empty());
}

TEST(GateSweep, CountsWhatPasses) {
  const std::vector<SeedVerdict> seeds = {{true, true, true, 0.9},
                                          {true, true, false, 0.8},
                                          {true, true, true, 0.7},
                                          {false, true, false, 0.6},
                                          {true, false, false, 0.95}};
  const auto sweep = sweepGate(seeds);
  ASSERT_EQ(sweep.size(), 2u);
  EXPECT_DOUBLE_EQ(sweep[0].recall, 0.25);
  EXPECT_DOUBLE_EQ(sweep[0].wrong, 0);
  EXPECT_DOUBLE_EQ(sweep[1].recall, 0.5);
  EXPECT_NEAR(sweep[1].wrong, 1.0 / 3, 1e-12);
  EXPECT_NEAR(*wrongAtRecall(seeds, 0.4), 1.0 / 3, 1e-12);
  EXPECT_FALSE(wrongAtRecall(seeds, 0.8));
}

}  // namespace
}  // namespace svoscope
