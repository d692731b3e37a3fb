// SPDX-License-Identifier: MIT
#include "engine/mapping/divergence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace svoscope {
namespace {

/// Variances with sigma1^2 + sigma2^2 = scale and log(sigma1 / sigma2) = r.
struct Spreads {
  double v1, v2;
  Spreads(double r, double scale = 1) {
    const double k2 = std::exp(2 * r);
    v1 = scale * k2 / (1 + k2);
    v2 = scale / (1 + k2);
  }
};

TEST(Divergence, KlIsTheIntegralOfItsDefinition) {
  const double m1 = 0.4, v1 = 0.03, m2 = 0.5, v2 = 0.05;
  double integral = 0;
  const double h = 1e-4;
  for (double x = -2; x < 3; x += h) {
    const double lp = -0.5 * (x - m1) * (x - m1) / v1 - 0.5 * std::log(2 * M_PI * v1);
    const double lq = -0.5 * (x - m2) * (x - m2) / v2 - 0.5 * std::log(2 * M_PI * v2);
    integral += h * std::exp(lp) * (lp - lq);
  }
  EXPECT_NEAR(klGaussian(m1, v1, m2, v2), integral, 1e-9);
  EXPECT_DOUBLE_EQ(klGaussian(m1, v1, m1, v1), 0);
  EXPECT_NE(klGaussian(m1, v1, m2, v2), klGaussian(m2, v2, m1, v1));
}

TEST(Divergence, TableAgreesWithNumericIntegrationEverywhere) {
  double worst = 0;
  for (double r = -15; r <= 15; r += 0.37) {
    const Spreads s(r);
    for (double d = -10; d <= 10; d += 0.29) {
      const double table = agreement(0.3, s.v1, 0.3 + d, s.v2).jsd;
      worst = std::max(worst, std::abs(table - jsdNumeric(0.3, s.v1, 0.3 + d, s.v2)));
      ASSERT_GE(table, 0);
      ASSERT_LE(table, kLog2);
      ASSERT_NEAR(table, agreement(0.3 + d, s.v2, 0.3, s.v1).jsd, 1e-12)
          << "not symmetric at r " << r << " d " << d;
    }
  }
  EXPECT_LE(worst, 1e-4);
}

TEST(Divergence, DependsOnlyOnOffsetAndRatio) {
  for (const double scale : {1e-10, 1e-4, 1.0, 1e6}) {
    const Spreads s(1.3, scale);
    EXPECT_NEAR(agreement(0, s.v1, 0.7 * std::sqrt(scale), s.v2).jsd,
                agreement(0, Spreads(1.3).v1, 0.7, Spreads(1.3).v2).jsd, 1e-9);
  }
}

TEST(Divergence, ReachesItsLimits) {
  EXPECT_NEAR(agreement(0.5, 1e-4, 0.5, 1e-4).jsd, 0, 1e-4);
  EXPECT_DOUBLE_EQ(agreement(0.5, 1e-4, 0.5, 1e-4).affinity, 1);
  const Agreement far = agreement(0.5, 1e-4, 5, 1e-4);
  EXPECT_DOUBLE_EQ(far.jsd, kLog2);
  EXPECT_DOUBLE_EQ(far.affinity, 0);
  const Agreement very_far = agreement(-1e200, 1e-300, 1e200, 1e-300);
  EXPECT_DOUBLE_EQ(very_far.jsd, kLog2);
  const Agreement unequal = agreement(0.5, 1e-20, 0.5, 1e12);
  EXPECT_DOUBLE_EQ(unequal.jsd, kLog2);
  EXPECT_DOUBLE_EQ(unequal.affinity, 1);  // no offset: as close as these spreads can be
}

TEST(Divergence, AffinityFallsWithTheOffset) {
  for (const double r : {0.0, 1.0, 4.0, 9.0}) {
    const Spreads s(r);
    double last = 1;
    for (double d = 0.05; d < 8; d += 0.05) {
      const double w = agreement(0, s.v1, d, s.v2).affinity;
      ASSERT_LT(w, last) << "r " << r << " d " << d;
      last = w;
    }
  }
}

TEST(Divergence, NumericAndTableAffinityAgree) {
  for (double r = 0; r < 5; r += 0.7) {
    const Spreads s(r);
    for (double d = 0; d < 3; d += 0.2)
      EXPECT_NEAR(agreement(0, s.v1, d, s.v2).affinity, agreementNumeric(0, s.v1, d, s.v2).affinity,
                  3e-3)
          << r << " " << d;
  }
}

TEST(Divergence, NotFiniteOrFlatMeansNoAgreement) {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               inf = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, nan, inf}) {
    EXPECT_DOUBLE_EQ(agreement(0, bad, 0, 1).jsd, kLog2);
    EXPECT_DOUBLE_EQ(agreement(0, 1, 0, bad).affinity, 0);
    EXPECT_DOUBLE_EQ(jsdNumeric(0, bad, 0, 1), kLog2);
    EXPECT_EQ(klGaussian(0, 1, 0, bad), inf);
  }
  EXPECT_DOUBLE_EQ(agreement(nan, 1, 0, 1).jsd, kLog2);
  EXPECT_EQ(klGaussian(nan, 1, 0, 1), inf);
}

}  // namespace
}  // namespace svoscope
