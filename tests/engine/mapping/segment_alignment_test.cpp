// SPDX-License-Identifier: MIT
#include "engine/mapping/segment_alignment.h"

#include <gtest/gtest.h>

#include "engine/mapping/segment_seed_update.h"
#include "tests/support/edge_world.h"

namespace svoscope {
namespace {

struct SegmentAlignmentTest : testing::Test {
  test::EdgeWorld world;
  PyramidPtr ref = world.render(SE3()), cur;
  SE3 T_true{so3Exp({0.01, -0.03, 0.05}), {-0.15, 0.04, 0.02}};

  SegmentAlignment align(const SE3& T_true_cur, const SE3& T_predicted) {
    cur = world.render(T_true_cur);
    SegmentQuery q{ref.get(),
                   cur.get(),
                   world.camera,
                   T_predicted,
                   makeSegmentAnchor(world.camera.project(world.a), world.camera.project(world.b),
                                     world.camera, 0),
                   {world.a, world.b}};
    return alignSegment(q, {}, {});
  }
  /// Distances of the found ends from the true line.
  void expectOnLine(const SegmentAlignment& r, const SE3& T, double within) {
    ASSERT_TRUE(r.ok) << r.samples << " samples, " << r.inliers << " inliers";
    const ImageLine line =
        lineThrough(world.camera.project(T * world.a), world.camera.project(T * world.b));
    for (const Vec2& px : r.px) EXPECT_LT(std::abs(line.distance(px)), within);
  }
};

TEST_F(SegmentAlignmentTest, FindsTheLineToSubPixel) {
  const SE3 off = SE3::exp((Vec6() << 0.008, -0.006, 0, 0.002, 0.001, 0.01).finished()) * T_true;
  const auto r = align(T_true, off);
  expectOnLine(r, T_true, 0.1);
  EXPECT_GT(std::abs(lineThrough(r.predicted[0], r.predicted[1]).distance(r.px[0])),
            0.3);  // had to move
}

TEST_F(SegmentAlignmentTest, PartOfASegmentIsEnough) {
  const SE3 T(so3Exp({0, -0.42, 0}), {0.05, 0, 0});
  const auto r = align(T, T);
  expectOnLine(r, T, 0.1);
  EXPECT_GT(r.t[0] + 1 - r.t[1], 0.1);  // an end is out of view
}

TEST_F(SegmentAlignmentTest, OutOfViewIsNoAlignment) {
  const SE3 T(so3Exp({0, 1.5, 0}), Vec3::Zero());
  EXPECT_FALSE(align(T, T).ok);
}

TEST(LineFit, IgnoresSamplesThatWentAstray) {
  std::vector<LineSample> samples;
  for (int i = 0; i < 6; ++i) samples.push_back({10.0 * i, 0.5 + 0.01 * 10 * i, 1});
  samples[2].offset += 4;
  const LineFit fit = fitLine(samples, 0.5);
  EXPECT_EQ(fit.inliers, 5);
  EXPECT_NEAR(fit.a, 0.5, 1e-9);
  EXPECT_NEAR(fit.b, 0.01, 1e-9);
}

}  // namespace
}  // namespace svoscope
