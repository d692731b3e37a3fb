// SPDX-License-Identifier: MIT
#include "engine/mapping/segment_seed_update.h"

#include <gtest/gtest.h>

#include "tests/support/edge_world.h"

namespace svoscope {
namespace {

struct SegmentSeedTest : testing::Test {
  test::EdgeWorld world;
  PyramidPtr ref = world.render(SE3()), cur;
  SegmentAnchor anchor = makeSegmentAnchor(world.camera.project(world.a),
                                           world.camera.project(world.b), world.camera, 0);
  MappingParameters parameters;

  SegmentMeasurement search(const SE3& T, double mu0, double mu1, double sigma) {
    cur = world.render(T);
    return searchSegment(
        {ref.get(), cur.get(), world.camera, T, anchor, {mu0, mu1}, {sigma, sigma}}, parameters);
  }
  double truth(int i) const { return 1 / (i ? world.b : world.a).norm(); }
};

TEST_F(SegmentSeedTest, SearchFindsTheDepthOfBothEnds) {
  const SE3 T(so3Exp({0.01, -0.02, 0}), {-0.15, 0.12, 0});
  const SegmentMeasurement m = search(T, 0.4, 0.4, 0.1);
  ASSERT_EQ(m.outcome, SearchOutcome::matched);
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(m.x[i], truth(i), m.tau[i]);
    EXPECT_LT(m.tau[i], 0.05);
  }
}

TEST_F(SegmentSeedTest, MotionAlongTheSegmentIsRefusedAndTheReasonKept) {
  const Vec3 along = (world.b - world.a).normalized();
  const SE3 T(Mat3::Identity(), -0.2 * along);
  SegmentSeed seed = makeSegmentSeed(anchor, 2.5, 1.5, parameters.filter);
  const SegmentMeasurement m = search(T, truth(0), truth(1), 0.05);
  EXPECT_EQ(m.outcome, SearchOutcome::edge_parallel);
  applySegmentMeasurement(seed, m, parameters.filter);
  EXPECT_EQ(seed.outcome, SearchOutcome::edge_parallel);
  EXPECT_EQ(seed.belief[0].b, parameters.filter.initial_ab);  // says nothing about the seed
  // The same for a line measured by the tracker.
  const Vec2 px[2] = {world.camera.project(T * world.a), world.camera.project(T * world.b)};
  EXPECT_EQ(measureFromLine(world.camera, T, anchor, px, parameters).outcome,
            SearchOutcome::edge_parallel);
}

TEST_F(SegmentSeedTest, TheTrackedLineGivesTheTrueDepths) {
  const SE3 T(so3Exp({0.01, -0.02, 0}), {-0.15, 0.12, 0});
  const Vec2 px[2] = {world.camera.project(T * world.a), world.camera.project(T * world.b)};
  const SegmentMeasurement m = measureFromLine(world.camera, T, anchor, px, parameters);
  ASSERT_EQ(m.outcome, SearchOutcome::tracked);
  for (int i = 0; i < 2; ++i) EXPECT_NEAR(m.x[i], truth(i), 1e-9);
}

TEST_F(SegmentSeedTest, BothEndsShareOneInlierRatioAndConverge) {
  SegmentSeed seed = makeSegmentSeed(anchor, 2.5, 1.5, parameters.filter);
  SegmentMeasurement m;
  m.outcome = SearchOutcome::matched;
  for (int k = 0; k < 60 && seed.status == SeedStatus::active; ++k) {
    for (int i = 0; i < 2; ++i) m.x[i] = truth(i) + 0.002 * ((k + i) % 3 - 1), m.tau[i] = 0.02;
    applySegmentMeasurement(seed, m, parameters.filter);
    EXPECT_EQ(seed.belief[0].a, seed.belief[1].a);
    EXPECT_EQ(seed.belief[0].b, seed.belief[1].b);
  }
  EXPECT_EQ(seed.status, SeedStatus::converged);
  for (int i = 0; i < 2; ++i) EXPECT_NEAR(seed.belief[i].mu, truth(i), 0.005);
}

TEST_F(SegmentSeedTest, HopelessSeedsAreRejected) {
  SegmentSeed seed = makeSegmentSeed(anchor, 2.5, 1.5, parameters.filter);
  SegmentMeasurement m;
  m.outcome = SearchOutcome::no_match;
  for (int k = 0; k < 200 && seed.status == SeedStatus::active; ++k)
    applySegmentMeasurement(seed, m, parameters.filter);
  EXPECT_EQ(seed.status, SeedStatus::rejected);
}

}  // namespace
}  // namespace svoscope
