// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/mapping/divergence.h"
#include "engine/mapping/seed_update.h"

namespace svoscope {
namespace {

Pinhole camera() {
  Pinhole c;
  c.width = 640;
  c.height = 480;
  c.fx = c.fy = 500;
  c.cx = 319.5;
  c.cy = 239.5;
  return c;
}

Seed freshSeed(const DepthFilterParameters& p) {
  DetectedFeature f;
  f.px = Vec2(300, 200);
  Seed seed = makeSeed(f, camera(), 2.0, 1.0, p);
  seed.id = 7;
  seed.keyframe_id = 3;
  return seed;
}

SeedMeasurement measured(double x, double tau, SearchOutcome outcome = SearchOutcome::matched) {
  SeedMeasurement m;
  m.outcome = outcome;
  m.x = x;
  m.tau = tau;
  m.px = Vec2(310, 205);
  m.score = 40;
  m.frame_index = 12;
  return m;
}

TEST(SeedHistory, BothRulesSeeTheSameMeasurements) {
  for (const FilterRule rule : {FilterRule::kl, FilterRule::js}) {
    DepthFilterParameters p;
    p.rule = rule;
    Seed seed = freshSeed(p);
    Belief kl = seed.belief, js = seed.belief;
    for (const double x : {0.5, 0.52, 0.9, 0.51}) {
      applyMeasurement(seed, measured(x, 0.02), p);
      kl = updateBelief(FilterRule::kl, kl, {x, 0.02 * 0.02, seed.range});
      js = updateBelief(FilterRule::js, js, {x, 0.02 * 0.02, seed.range});
    }
    applyMeasurement(seed, measured(0, 0, SearchOutcome::no_match), p);
    EXPECT_DOUBLE_EQ(beliefView(seed, FilterRule::kl, rule).mu, static_cast<float>(kl.mu));
    EXPECT_DOUBLE_EQ(beliefView(seed, FilterRule::js, rule).mu, static_cast<float>(js.mu));
    EXPECT_FLOAT_EQ(beliefView(seed, FilterRule::kl, rule).b, static_cast<float>(kl.b + 1));
    EXPECT_FLOAT_EQ(beliefView(seed, FilterRule::js, rule).b, static_cast<float>(js.b + 1));
    EXPECT_DOUBLE_EQ(seed.belief.mu, rule == FilterRule::kl ? kl.mu : js.mu);
  }
}

TEST(SeedHistory, WithoutShadowTheOtherRuleIsMarkedAsNotComputed) {
  DepthFilterParameters p;
  p.shadow = false;
  Seed seed = freshSeed(p);
  applyMeasurement(seed, measured(0.5, 0.02), p);
  EXPECT_GT(beliefView(seed, FilterRule::kl, p.rule).sigma, 0);
  EXPECT_EQ(beliefView(seed, FilterRule::js, p.rule).sigma, 0);
  p.shadow = true;  // too late: it missed a measurement
  applyMeasurement(seed, measured(0.5, 0.02), p);
  EXPECT_EQ(beliefView(seed, FilterRule::js, p.rule).sigma, 0);
}

TEST(SeedHistory, UpdatesAreDescribed) {
  DepthFilterParameters p;
  const Seed before = freshSeed(p);
  Seed after = before;
  const SeedMeasurement m = measured(0.6, 0.03);
  applyMeasurement(after, m, p);
  const SeedUpdateView v = describeUpdate(before, after, m, p.rule);
  EXPECT_EQ(v.seed_id, 7);
  EXPECT_EQ(v.keyframe_id, 3);
  EXPECT_EQ(v.frame_index, 12);
  EXPECT_EQ(v.px, Vec2f(310, 205));
  EXPECT_FLOAT_EQ(v.score, 40);
  EXPECT_FLOAT_EQ(v.before[FilterRule::kl].mu, static_cast<float>(before.belief.mu));
  EXPECT_FLOAT_EQ(v.after[FilterRule::kl].mu, static_cast<float>(after.belief.mu));
  EXPECT_FLOAT_EQ(v.after[FilterRule::js].mu, static_cast<float>(after.shadow[FilterRule::js].mu));
  EXPECT_FLOAT_EQ(
      v.kl_belief_measurement,
      static_cast<float>(klGaussian(before.belief.mu, before.belief.sigma2, 0.6, 0.03 * 0.03)));
  EXPECT_FLOAT_EQ(
      v.kl_measurement_belief,
      static_cast<float>(klGaussian(0.6, 0.03 * 0.03, before.belief.mu, before.belief.sigma2)));
  EXPECT_GT(v.jsd, 0);
  EXPECT_LT(v.jsd, kLog2);
  EXPECT_GT(v.affinity, 0);
}

TEST(SeedHistory, EndingsHaveReasons) {
  DepthFilterParameters p;
  Seed seed = freshSeed(p);
  for (int i = 0; i < 500 && seed.ending == SeedEnding::none; ++i)
    applyMeasurement(seed, measured(0, 0, SearchOutcome::no_match), p);
  EXPECT_EQ(seed.ending, SeedEnding::inlier_ratio);
  EXPECT_EQ(seed.status, SeedStatus::rejected);

  Seed behind = freshSeed(p);
  for (int i = 0; i < 50 && behind.ending == SeedEnding::none; ++i)
    applyMeasurement(behind, measured(-0.4, 0.01), p);
  EXPECT_EQ(behind.ending, SeedEnding::no_depth);

  Seed broken = freshSeed(p);
  broken.belief.mu = std::numeric_limits<double>::quiet_NaN();
  applyMeasurement(broken, measured(0.5, 0.01), p);
  EXPECT_EQ(broken.ending, SeedEnding::not_finite);
  EXPECT_EQ(broken.status, SeedStatus::rejected);
}

TEST(SeedHistory, SeedsEndWithTheirKeyframe) {
  Map map;
  Keyframe& keyframe = map.keyframes[3];
  keyframe.id = 3;
  keyframe.seeds.push_back(freshSeed({}));
  map.removeKeyframe(3);
  ASSERT_EQ(map.orphans.size(), 1u);
  EXPECT_EQ(map.orphans[0].seed.ending, SeedEnding::keyframe_removed);
  EXPECT_EQ(map.orphans[0].seed.id, 7);
}

TEST(SeedHistory, DegenerateMeasurementsLeaveTheSeedUsable) {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               inf = std::numeric_limits<double>::infinity();
  for (const FilterRule rule : {FilterRule::kl, FilterRule::js}) {
    DepthFilterParameters p;
    p.rule = rule;
    Seed seed = freshSeed(p);
    const Seed before = seed;
    for (SeedMeasurement m : {measured(nan, 0.1), measured(0.5, nan), measured(0.5, 0),
                              measured(inf, 0.1), measured(0.5, inf)}) {
      m.score = nan;
      const Seed last = seed;
      applyMeasurement(seed, m, p);
      const SeedUpdateView v = describeUpdate(last, seed, m, p.rule);
      for (const float value : {v.score, v.x, v.tau, v.jsd, v.affinity, v.kl_belief_measurement,
                                v.kl_measurement_belief})
        EXPECT_TRUE(std::isfinite(value));
    }
    EXPECT_DOUBLE_EQ(seed.belief.mu, before.belief.mu);
    EXPECT_EQ(seed.status, SeedStatus::active);
    // A measurement at infinity with a wide tau, as without parallax.
    applyMeasurement(seed, measured(1e-9, 1e6), p);
    EXPECT_TRUE(std::isfinite(seed.belief.mu));
    EXPECT_EQ(seed.ending, SeedEnding::none);
  }
}

TEST(SeedHistory, ZeroBaselineIsNoMeasurement) {
  EXPECT_GE(inverseDistanceSigma(SE3(), Vec3::UnitZ(), 0.5, 1, 500), 1e5);
  cv::Mat gray(240, 320, CV_8UC1);
  for (int y = 0; y < gray.rows; ++y) {
    for (int x = 0; x < gray.cols; ++x)
      gray.at<std::uint8_t>(y, x) =
          static_cast<std::uint8_t>(127 + 60 * std::sin(0.4 * x) * std::cos(0.3 * y));
  }
  Pinhole c = camera();
  c.width = 320;
  c.height = 240;
  const PyramidPtr pyramid = buildPyramid(gray, 3);
  EpipolarQuery q;
  q.ref = q.cur = pyramid.get();
  q.camera = c;
  q.f_ref = c.bearing(q.px_ref = Vec2(150, 120));
  q.mu = 0.5;
  q.sigma = 0.1;
  EXPECT_EQ(searchEpipolar(q, {}, {}).outcome, SearchOutcome::low_parallax);
  // At the border, and out of view.
  q.T_cur_ref = SE3(Eigen::Quaterniond::Identity(), Vec3(0.1, 0, 0));
  q.f_ref = c.bearing(q.px_ref = Vec2(318, 120));
  EXPECT_EQ(searchEpipolar(q, {}, {}).outcome, SearchOutcome::out_of_view);
  q.f_ref = c.bearing(q.px_ref = Vec2(150, 120));
  q.T_cur_ref = SE3(Eigen::Quaterniond::Identity(), Vec3(0, 0, -10));
  q.mu = 1;
  EXPECT_EQ(searchEpipolar(q, {}, {}).outcome, SearchOutcome::out_of_view);
}

}  // namespace
}  // namespace svoscope
