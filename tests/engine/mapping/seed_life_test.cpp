// SPDX-License-Identifier: MIT
// What seeds of points and of segments share: the tests run on both kinds.
#include "engine/mapping/seed_life.h"

#include <gtest/gtest.h>

#include <limits>

#include "engine/mapping/segment_seed_update.h"

namespace svoscope {
namespace {

/// A measurement of the same inverse distance for a seed of either kind.
void measure(Seed& seed, double x, double tau, SearchOutcome outcome = SearchOutcome::matched) {
  SeedMeasurement m;
  m.outcome = outcome;
  m.frame_index = 7;
  m.x = x;
  m.tau = tau;
  applyMeasurement(seed, m, {});
}
void measure(SegmentSeed& seed, double x, double tau,
             SearchOutcome outcome = SearchOutcome::matched) {
  SegmentMeasurement m;
  m.outcome = outcome;
  m.frame_index = 7;
  for (int i = 0; i < 2; ++i) m.x[i] = x, m.tau[i] = tau;
  applySegmentMeasurement(seed, m, {});
}

Belief& firstBelief(Seed& seed) { return seed.belief; }
Belief& firstBelief(SegmentSeed& seed) { return seed.belief[0]; }

template <class S>
class SeedLifeOf : public testing::Test {};
using Kinds = testing::Types<Seed, SegmentSeed>;
TYPED_TEST_SUITE(SeedLifeOf, Kinds);

TYPED_TEST(SeedLifeOf, EndsOnceAndTakesNoFurtherMeasurement) {
  TypeParam seed;
  firstBelief(seed).mu = -1;
  measure(seed, 0, 0, SearchOutcome::no_match);
  ASSERT_EQ(seed.ending, SeedEnding::no_depth);
  EXPECT_EQ(seed.status, SeedStatus::rejected);
  EXPECT_FALSE(alive(seed));
  measure(seed, 1, 0.1);
  EXPECT_EQ(seed.updates, 0);
  EXPECT_EQ(seed.outcome, SearchOutcome::no_match);
  EXPECT_EQ(firstBelief(seed).mu, -1);
  endSeed(seed, SeedEnding::promoted);
  EXPECT_EQ(seed.ending, SeedEnding::no_depth);
  EXPECT_EQ(seed.status, SeedStatus::rejected);
}

TYPED_TEST(SeedLifeOf, EndsIfItsBeliefIsNotFinite) {
  TypeParam seed;
  firstBelief(seed).mu = std::numeric_limits<double>::quiet_NaN();
  measure(seed, 0, 0, SearchOutcome::no_match);
  EXPECT_EQ(seed.ending, SeedEnding::not_finite);
}

TYPED_TEST(SeedLifeOf, IsMeasuredUntilItConverges) {
  TypeParam seed;
  measure(seed, 1, 0.1, SearchOutcome::low_parallax);
  EXPECT_EQ(seed.updates + seed.failures, 0);
  EXPECT_EQ(seed.outcome, SearchOutcome::low_parallax);
  EXPECT_EQ(seed.last_frame, -1);
  for (int i = 0; i < 100 && seed.status == SeedStatus::active; ++i) measure(seed, 1, 0.01);
  EXPECT_EQ(seed.status, SeedStatus::converged);
  EXPECT_EQ(seed.ending, SeedEnding::none);
  EXPECT_TRUE(alive(seed));
  EXPECT_GT(seed.updates, 1);
  EXPECT_EQ(seed.last_frame, 7);
}

TYPED_TEST(SeedLifeOf, FailuresEndItByItsInlierRatio) {
  TypeParam seed;
  int misses = 0;
  for (; alive(seed) && misses < 1000; ++misses) measure(seed, 0, 0, SearchOutcome::no_match);
  EXPECT_EQ(seed.ending, SeedEnding::inlier_ratio);
  EXPECT_EQ(seed.failures, misses);
  EXPECT_GT(misses, 50) << "a = b = 10 at the start, rejected below 0.08";
}

TYPED_TEST(SeedLifeOf, IsFoundByIdAndDroppedWithTheNextFrame) {
  std::vector<TypeParam> seeds(4);
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    seeds[i].id = static_cast<std::int64_t>(3 * i);
    seeds[i].outcome = SearchOutcome::matched;
  }
  EXPECT_EQ(findById(seeds, 6), &seeds[2]);
  EXPECT_EQ(findById(seeds, 5), nullptr);
  EXPECT_EQ(findById(seeds, 10), nullptr);
  endSeed(seeds[1], SeedEnding::promoted);
  endSeed(seeds[3], SeedEnding::keyframe_removed);
  EXPECT_EQ(seeds[1].status, SeedStatus::promoted);
  EXPECT_EQ(seeds[3].status, SeedStatus::rejected);
  dropEnded(seeds);
  ASSERT_EQ(seeds.size(), 2u);
  EXPECT_EQ(seeds[1].id, 6);
  EXPECT_EQ(seeds[1].outcome, SearchOutcome::none);
}

TEST(SeedLife, ASegmentEndsIfOneOfItsEndsHasNoDepth) {
  SegmentSeed seed;
  seed.belief[1].mu = 0;
  measure(seed, 0, 0, SearchOutcome::no_match);
  EXPECT_EQ(seed.ending, SeedEnding::no_depth);
}

TEST(SeedLife, ASegmentConvergesWithBothEndsOnly) {
  SegmentSeed seed;
  seed.belief[0].sigma2 = 1e-8;
  judge(seed, seed.belief, 2, [] {
    DepthFilterParameters p;
    p.min_inlier_ratio = 0.4;
    return p;
  }());
  EXPECT_EQ(seed.status, SeedStatus::active);
}

}  // namespace
}  // namespace svoscope
