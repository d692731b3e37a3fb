// SPDX-License-Identifier: MIT
// The update against numerical integration of the exact posterior, and against the closed form as
// printed by Vogiatzis & Hernandez.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "engine/mapping/depth_filter.h"

namespace svoscope {
namespace {

double normal(double x, double mean, double variance) {
  return std::exp(-0.5 * (x - mean) * (x - mean) / variance) / std::sqrt(2 * M_PI * variance);
}

struct Moments {
  double mean = 0, variance = 0, rho = 0, rho2 = 0;
};

/// Moments of [rho N(x | z, tau2) + (1 - rho) / R] N(z | mu, sigma2) Beta(rho | a, b): a grid over
/// z and rho, normalised numerically.
Moments integrate(const Belief& q, const Measurement& m) {
  const double s = std::sqrt(q.sigma2), t = std::sqrt(m.tau2);
  const double lo = std::min(q.mu - 9 * s, std::max(m.x - 9 * t, q.mu - 30 * s));
  const double hi = std::max(q.mu + 9 * s, std::min(m.x + 9 * t, q.mu + 30 * s));
  constexpr int kZ = 4001, kRho = 801;
  double inlier[3] = {}, outlier[3] = {};  // integrals of N N z^k and N z^k, z about mu
  for (int i = 0; i < kZ; ++i) {
    const double z = lo + (hi - lo) * i / (kZ - 1), d = z - q.mu, n = normal(z, q.mu, q.sigma2);
    for (int k = 0; k < 3; ++k) {
      inlier[k] += n * normal(m.x, z, m.tau2) * std::pow(d, k);
      outlier[k] += n / m.range * std::pow(d, k);
    }
  }
  double total = 0, mean = 0, square = 0, rho1 = 0, rho2 = 0;
  for (int i = 1; i < kRho - 1; ++i) {
    const double rho = static_cast<double>(i) / (kRho - 1);
    const double beta = std::pow(rho, q.a - 1) * std::pow(1 - rho, q.b - 1);
    const double mass = beta * (rho * inlier[0] + (1 - rho) * outlier[0]);
    total += mass;
    mean += beta * (rho * inlier[1] + (1 - rho) * outlier[1]);
    square += beta * (rho * inlier[2] + (1 - rho) * outlier[2]);
    rho1 += rho * mass;
    rho2 += rho * rho * mass;
  }
  mean /= total;
  return {q.mu + mean, square / total - mean * mean, rho1 / total, rho2 / total};
}

void expectMoments(const Belief& q, const Measurement& m) {
  const Moments exact = integrate(q, m);
  const Belief next = updateBelief(FilterRule::kl, q, m);
  const double scale = std::sqrt(q.sigma2);
  EXPECT_NEAR(next.mu, exact.mean, 1e-4 * scale);
  EXPECT_NEAR(next.sigma2, exact.variance, 1e-3 * exact.variance);
  const double ab = next.a + next.b;
  EXPECT_NEAR(next.a / ab, exact.rho, 1e-5);
  EXPECT_NEAR(next.a * (next.a + 1) / (ab * (ab + 1)), exact.rho2, 1e-5);
}

TEST(MomentMatch, MatchesTheMomentsOfTheExactPosterior) {
  expectMoments({0.5, 0.01, 10, 10}, {0.55, 0.0025, 1});
  expectMoments({0.5, 0.01, 10, 10}, {0.9, 0.0025, 1});  // 3.6 sigma away: mostly outlier
  expectMoments({0.5, 0.01, 3, 30}, {0.52, 0.0001, 2});
  expectMoments({0.5, 0.0004, 25, 6}, {0.51, 0.01, 1});  // vague measurement
  expectMoments({0.8, 0.02, 4, 4}, {0.3, 0.02, 3});
}

/// moment_match of the reference implementation, term by term.
Belief printedFormula(const Belief& q, const Measurement& m, double weight) {
  const double s = 1 / (1 / q.sigma2 + 1 / m.tau2), mean = s * (q.mu / q.sigma2 + m.x / m.tau2);
  const double a = q.a, b = q.b;
  double c1 = weight * a / (a + b) * normal(m.x, q.mu, q.sigma2 + m.tau2),
         c2 = b / (a + b) / m.range;
  const double sum = c1 + c2;
  c1 /= sum;
  c2 /= sum;
  const double f = c1 * (a + 1) / (a + b + 1) + c2 * a / (a + b + 1);
  const double e = (c1 * (a + 1) * (a + 2) + c2 * a * (a + 1)) / ((a + b + 1) * (a + b + 2));
  Belief next;
  next.mu = c1 * mean + c2 * q.mu;
  next.sigma2 = c1 * (s + mean * mean) + c2 * (q.sigma2 + q.mu * q.mu) - next.mu * next.mu;
  next.a = (e - f) / (f - e / f);
  next.b = next.a * (1 - f) / f;
  return next;
}

TEST(MomentMatch, AgreesWithThePrintedFormula) {
  std::mt19937 rng(1);
  const auto uniform = [&rng](double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(rng);
  };
  for (int i = 0; i < 400; ++i) {
    const Belief q{uniform(0.2, 1.2), std::pow(10, uniform(-6, -1.3)), uniform(3, 40),
                   uniform(3, 40)};
    const double tau2 = std::pow(10, uniform(-6, -1.3));
    const Measurement m{q.mu + 4 * uniform(-1, 1) * std::sqrt(q.sigma2 + tau2), tau2, 1};
    for (const double weight : {1.0, 0.3}) {
      const Belief ours = momentMatch(q, m, weight), printed = printedFormula(q, m, weight);
      EXPECT_NEAR(ours.mu, printed.mu, 1e-12);
      EXPECT_NEAR(ours.sigma2, printed.sigma2, 1e-12);
      EXPECT_NEAR(ours.a, printed.a, 1e-7 * printed.a);
      EXPECT_NEAR(ours.b, printed.b, 1e-7 * printed.b);
    }
  }
}

TEST(MomentMatch, VectorsOfTheReferenceImplementation) {
  const Belief near = updateBelief(FilterRule::kl, {0.5, 0.01, 10, 10}, {0.55, 0.0025, 1});
  EXPECT_NEAR(near.mu, 0.530540793517, 1e-11);
  EXPECT_NEAR(near.sigma2, 0.00418073296854, 1e-11);
  EXPECT_NEAR(near.a, 10.3883802697, 1e-8);
  EXPECT_NEAR(near.b, 9.87970943967, 1e-8);
  const Belief far = updateBelief(FilterRule::kl, {0.5, 0.01, 10, 10}, {0.9, 0.0025, 1});
  EXPECT_NEAR(far.mu, 0.501886049515, 1e-11);
  EXPECT_NEAR(far.sigma2, 0.010552827424, 1e-11);
  EXPECT_NEAR(far.a, 9.99418238876, 1e-8);
  EXPECT_NEAR(far.b, 10.9812379147, 1e-8);
}

TEST(MomentMatch, AMeasurementFarAwayCountsAsAnOutlier) {
  const Belief q{0.5, 0.0001, 10, 10};
  const Belief next = updateBelief(FilterRule::kl, q, {3.0, 0.0001, 1});
  EXPECT_NEAR(next.mu, q.mu, 1e-9);
  EXPECT_NEAR(next.sigma2, q.sigma2, 1e-9);
  EXPECT_NEAR(next.inlierRatio(), 10.0 / 21, 1e-9);  // exactly one outlier seen
}

TEST(MomentMatch, ASureBeliefAndASureMeasurementAreLimits) {
  const Belief sure = updateBelief(FilterRule::kl, {0.5, 1e-16, 10, 10}, {0.51, 0.01, 1});
  EXPECT_NEAR(sure.mu, 0.5, 1e-12);
  EXPECT_GT(sure.sigma2, 0);
  const Belief taught = updateBelief(FilterRule::kl, {0.5, 0.01, 10, 10}, {0.52, 1e-14, 1});
  EXPECT_NEAR(taught.mu, 0.52, 0.01);
  EXPECT_GT(taught.sigma2, 0);
  EXPECT_LT(taught.sigma2, 0.01);
  EXPECT_GT(taught.inlierRatio(), 0.5);
}

TEST(MomentMatch, AVagueMeasurementTeachesNothing) {
  const Belief q{0.5, 0.01, 10, 10};
  const Belief next = updateBelief(FilterRule::kl, q, {0.5, 1e12, 1});
  EXPECT_NEAR(next.mu, q.mu, 1e-9);
  EXPECT_NEAR(next.sigma2, q.sigma2, 1e-6);
}

TEST(MomentMatch, UnusableInputLeavesTheBelief) {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               inf = std::numeric_limits<double>::infinity();
  const Belief q{0.5, 0.01, 12, 9};
  for (const Measurement& m : {Measurement{nan, 0.01, 1},
                               {0.5, nan, 1},
                               {inf, 0.01, 1},
                               {0.5, inf, 1},
                               {0.5, 0, 1},
                               {0.5, -1, 1},
                               {0.5, 0.01, 0},
                               {0.5, 0.01, nan}}) {
    const Belief next = updateBelief(FilterRule::kl, q, m);
    EXPECT_EQ(next.mu, q.mu);
    EXPECT_EQ(next.sigma2, q.sigma2);
    EXPECT_EQ(next.a, q.a);
    EXPECT_EQ(next.b, q.b);
  }
}

TEST(MomentMatch, ManyUpdatesStayFiniteAndNormal) {
  std::mt19937 rng(7);
  std::normal_distribution<double> noise(0, 0.02);
  Belief q{0.5, 0.03, 10, 10};
  for (int i = 0; i < 20000; ++i) {
    q = updateBelief(FilterRule::kl, q, {0.7 + noise(rng), 0.0004, 1});
    ASSERT_TRUE(std::isfinite(q.mu) && q.sigma2 > 0 && q.a > 0 && q.b > 0) << i;
  }
  EXPECT_NEAR(q.mu, 0.7, 0.002);
  EXPECT_GT(q.inlierRatio(), 0.97);
  EXPECT_GT(q.a, 1000);
}

TEST(MomentMatch, LargeBetaParametersMoveByOneCount) {
  for (const double large : {1e3, 1e5, 1e6}) {
    const Belief q{0.5, 1e-4, large, large};
    const Belief in = updateBelief(FilterRule::kl, q, {0.5, 1e-6, 1e3}),
                 out = updateBelief(FilterRule::kl, q, {5, 1e-6, 1});
    EXPECT_NEAR(in.a + in.b, 2 * large + 1, 0.01 * large);
    EXPECT_GT(in.inlierRatio(), 0.5);
    EXPECT_LT(out.inlierRatio(), 0.5);
  }
}

TEST(MomentMatch, SigmaNeverGrowsOnAgreement) {
  for (const double tau2 : {1e-8, 1e-4, 1e-2, 1.0}) {
    const Belief q{0.5, 0.01, 10, 10};
    EXPECT_LT(updateBelief(FilterRule::kl, q, {0.5, tau2, 1}).sigma2, q.sigma2) << tau2;
  }
}

}  // namespace
}  // namespace svoscope
