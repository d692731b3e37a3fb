// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

#include "engine/mapping/rules/js.h"

namespace svoscope {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

struct Vector {
  std::map<std::string, double> value;
  Belief belief(const std::string& prefix) const {
    return {value.at(prefix + "mu"), value.at(prefix + "s2"), value.at(prefix + "a"),
            value.at(prefix + "b")};
  }
  Measurement measurement() const { return {value.at("x"), value.at("t2"), value.at("R")}; }
};

std::vector<Vector> readVectors() {
  std::ifstream in(SVOSCOPE_SOURCE_DIR "/tests/data/depth_filter_vectors.csv");
  std::vector<std::string> names;
  std::vector<Vector> vectors;
  std::string line, cell;
  while (std::getline(in, line)) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream cells(line);
    if (names.empty()) {
      while (std::getline(cells, cell, ',')) names.push_back(cell);
      continue;
    }
    vectors.emplace_back();
    for (const std::string& name : names) {
      std::getline(cells, cell, ',');
      vectors.back().value[name] = std::stod(cell);
    }
  }
  return vectors;
}

void expectRelative(const Belief& is, const Belief& should, double tolerance) {
  EXPECT_NEAR(is.mu, should.mu, tolerance * std::abs(should.mu));
  EXPECT_NEAR(is.sigma2, should.sigma2, tolerance * should.sigma2);
  EXPECT_NEAR(is.a, should.a, tolerance * should.a);
  EXPECT_NEAR(is.b, should.b, tolerance * should.b);
}

void expectUsable(const Belief& q) {
  EXPECT_TRUE(std::isfinite(q.mu) && std::isfinite(q.sigma2) && std::isfinite(q.a) &&
              std::isfinite(q.b));
  EXPECT_GT(q.sigma2, 0);
  EXPECT_GT(q.a, 0);
  EXPECT_GT(q.b, 0);
}

TEST(DepthFilter, OneStepUpdatesEqualTheReference) {
  const auto vectors = readVectors();
  ASSERT_GE(vectors.size(), 300u);
  for (const Vector& v : vectors) {
    const Belief q = v.belief("");
    const Measurement m = v.measurement();
    const Agreement a = agreementNumeric(q.mu, q.sigma2, m.x, m.tau2);
    EXPECT_NEAR(klGaussian(q.mu, q.sigma2, m.x, m.tau2), v.value.at("kl"), 1e-6 * v.value.at("kl"));
    EXPECT_NEAR(a.jsd, v.value.at("jsd"), 1e-6 * v.value.at("jsd") + 1e-9);
    expectRelative(updateBelief(FilterRule::kl, q, m), v.belief("kl_"), 1e-6);
    expectRelative(updateJs(q, m, {true, true}, a), v.belief("js_"), 1e-6);
    expectRelative(updateJs(q, m, {true, false}, a), v.belief("fuse_"), 1e-6);
    expectRelative(updateJs(q, m, {false, true}, a), v.belief("weight_"), 1e-6);
    // The table in place of the integral.
    EXPECT_NEAR(agreement(q.mu, q.sigma2, m.x, m.tau2).jsd, v.value.at("jsd"), 1e-4);
    expectRelative(updateBelief(FilterRule::js, q, m), v.belief("js_"), 2e-3);
  }
}

TEST(DepthFilter, BothSwitchesOffIsTheKlRule) {
  const Belief q{0.5, 0.01, 10, 10};
  const Measurement m{0.55, 1e-3, 1};
  expectRelative(updateBelief(FilterRule::js, q, m, {{false, false}}),
                 updateBelief(FilterRule::kl, q, m), 1e-15);
}

TEST(DepthFilter, AtTheLimitTheJsRuleTakesTheMeasurementForAnOutlier) {
  const Belief q{0.5, 1e-4, 10, 10};
  const Belief next = updateBelief(FilterRule::js, q, {0.9, 1e-4, 1});
  EXPECT_NEAR(next.mu, q.mu, 1e-6);
  EXPECT_LT(next.inlierRatio(), q.inlierRatio());
}

TEST(DepthFilter, MeasurementsThatAreNotNumbersChangeNothing) {
  const Belief q{0.5, 0.01, 10, 10};
  for (const Measurement& m :
       {Measurement{kNan, 1e-3, 1}, Measurement{0.5, kNan, 1}, Measurement{kInf, 1e-3, 1},
        Measurement{0.5, kInf, 1}, Measurement{0.5, -1, 1}, Measurement{0.5, 0, 1},
        Measurement{0.5, 1e-3, 0}, Measurement{0.5, 1e-3, kNan}}) {
    for (const FilterRule rule : kRules) expectRelative(updateBelief(rule, q, m, {}), q, 0);
  }
}

TEST(DepthFilter, ExtremeSpreadsStayFinite) {
  const double tiny = 1e-300, small = 1e-12, large = 1e12;
  for (const double s2 : {tiny, small, 1e-2, large}) {
    for (const double t2 : {tiny, small, 1e-2, large}) {
      for (const double x : {0.5, 0.5 + 1e-9, 0.0, 1e-9, 1e6}) {
        const Belief q{0.5, s2, 10, 10};
        for (const FilterRule rule : kRules) expectUsable(updateBelief(rule, q, {x, t2, 1}, {}));
      }
    }
  }
}

TEST(DepthFilter, CountsAtTheirLimitsStayFinite) {
  for (const double a : {1e-9, 1.0, 1e9}) {
    for (const double b : {1e-9, 1.0, 1e9}) {
      for (const FilterRule rule : kRules) {
        Belief q{0.5, 0.01, a, b};
        for (int i = 0; i < 50; ++i) q = updateBelief(rule, q, {i % 3 ? 0.5 : 0.9, 1e-4, 1}, {});
        expectUsable(q);
      }
    }
  }
}

TEST(DepthFilter, ManyGoodMeasurementsConverge) {
  for (const FilterRule rule : kRules) {
    Belief q{0.5, 1.0 / 36, 10, 10};
    for (int i = 0; i < 500; ++i)
      q = updateBelief(rule, q, {0.62 + (i % 2 ? 0.001 : -0.001), 1e-5, 1}, {});
    expectUsable(q);
    EXPECT_NEAR(q.mu, 0.62, 1e-3);
    EXPECT_GT(q.inlierRatio(), 0.9);
  }
}

}  // namespace
}  // namespace svoscope
