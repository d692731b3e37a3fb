// SPDX-License-Identifier: MIT
#include "engine/geometry/segment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace svoscope {
namespace {

Pinhole camera() { return {640, 480, 500, 510, 319.5, 239.5}; }

TEST(Segment, DistanceJacobiansAgreeWithFiniteDifferences) {
  const Pinhole c = camera();
  const ImageLine line = lineThrough({100, 80}, {400, 300});
  const SE3 T(so3Exp({0.1, -0.2, 0.3}), {0.2, 0.1, -0.1});
  // The two ends of a segment at very different depths: each has its own Jacobian.
  for (const Vec3& p_world : {Vec3(-0.4, -0.3, 1.1), Vec3(1.5, 0.7, 6.0)}) {
    const auto distance = [&](const SE3& pose, const Vec3& p) {
      return line.distance(c.project(pose * p));
    };
    const Row6 J = lineTwistJacobian(c, T * p_world, line.normal);
    const Row3 Jp = linePointJacobian(c, T * p_world, T.rotation(), line.normal);
    constexpr double h = 1e-6;
    for (int k = 0; k < 6; ++k) {
      const Vec6 d = h * Vec6::Unit(k);
      const double slope =
          (distance(SE3::exp(d) * T, p_world) - distance(SE3::exp(-d) * T, p_world)) / (2 * h);
      EXPECT_NEAR(J[k], slope, 1e-4 * (1 + std::abs(slope))) << k;
    }
    for (int k = 0; k < 3; ++k) {
      const Vec3 d = h * Vec3::Unit(k);
      const double slope = (distance(T, p_world + d) - distance(T, p_world - d)) / (2 * h);
      EXPECT_NEAR(Jp[k], slope, 1e-4 * (1 + std::abs(slope))) << k;
    }
  }
}

TEST(Segment, PlaneGivesTheDistanceInPixels) {
  const Pinhole c = camera();
  const ImageLine line = lineThrough({100, 80}, {400, 300});
  const Vec3 p(0.3, -0.2, 2.5);
  EXPECT_NEAR(linePlane(c, line).dot(p) / p.z(), line.distance(c.project(p)), 1e-9);
}

TEST(Segment, ClipsToTheImageAlsoFromBehindTheCamera) {
  const Pinhole c = camera();
  double t0 = 0, t1 = 0;
  ASSERT_TRUE(clipToImage(c, {-0.1, 0, 1}, {0.1, 0, 1}, 10, t0, t1));
  EXPECT_EQ(t0, 0);
  EXPECT_EQ(t1, 1);
  // Runs from in front of the camera to behind it.
  const Vec3 a(0.05, 0.3, 3), b(0.05, 0.3, -3);
  ASSERT_TRUE(clipToImage(c, a, b, 10, t0, t1));
  EXPECT_EQ(t0, 0);
  const Vec2 px = c.project(Vec3((1 - t1) * a + t1 * b));
  EXPECT_NEAR(px.y(), c.height - 1 - 10, 1e-6);
  EXPECT_FALSE(clipToImage(c, {-5, 0, 1}, {-5, 1, 1}, 10, t0, t1));
  EXPECT_FALSE(clipToImage(c, {0, 0, -1}, {0, 0.1, -2}, 10, t0, t1));
}

TEST(Segment, RayMeetsTheLineAtTheTrueDepth) {
  const Pinhole c = camera();
  const SE3 T(so3Exp({0.02, -0.05, 0.01}), {-0.3, 0.05, 0.02});
  const Vec3 a(-0.2, 0.4, 2.0), b(0.1, -0.3, 2.6);
  const ImageLine line = lineThrough(c.project(T * a), c.project(T * b));
  const RayLineIntersection r = intersectRayLine(c, T, a.normalized(), line);
  EXPECT_NEAR(r.inv_distance, 1 / a.norm(), 1e-9);
  EXPECT_GT(r.cosine, 0.5);
}

TEST(Segment, ALineAlongTheEpipolarLineIsNoMeasurement) {
  const Pinhole c = camera();
  const SE3 T(Mat3::Identity(), {-0.3, 0, 0});  // moves along x, the segment is horizontal
  const ImageLine line = lineThrough({100, 200}, {300, 200});
  EXPECT_LT(intersectRayLine(c, T, c.bearing({150, 200}), line).cosine, 1e-9);
}

/// Noise across the line at both ends of the observed piece against the predicted sigma.
TEST(Segment, DepthNoiseAgreesWithMonteCarlo) {
  const Pinhole c = camera();
  const SE3 T(so3Exp({0.02, -0.05, 0.01}), {-0.3, 0.05, 0.02});
  const Vec3 a(-0.2, 0.4, 2.0), b(0.1, -0.3, 2.6);
  const Vec2 pa = c.project(T * a), pb = c.project(T * b);
  const Vec2 normal = lineThrough(pa, pb).normal;
  constexpr double kNoise = 0.5;
  std::mt19937 rng(1);
  std::normal_distribution<double> noise(0, kNoise);
  for (const double u : {0.0, 0.5, 1.3}) {  // an end, the middle, and beyond what is visible
    const Vec3 p = (1 - u) * a + u * b;
    double sum = 0, squares = 0;
    constexpr int kRuns = 20000;
    for (int i = 0; i < kRuns; ++i) {
      const ImageLine line = lineThrough(pa + noise(rng) * normal, pb + noise(rng) * normal);
      const double x = intersectRayLine(c, T, p.normalized(), line).inv_distance;
      sum += x;
      squares += x * x;
    }
    const double mean = sum / kRuns, sigma = std::sqrt(squares / kRuns - mean * mean);
    const RayLineIntersection r = intersectRayLine(c, T, p.normalized(), lineThrough(pa, pb));
    const double predicted = kNoise * r.per_px * std::sqrt(lineVariance(pa, pb, c.project(T * p)));
    EXPECT_NEAR(sigma / predicted, 1, 0.03) << u;
    EXPECT_NEAR(mean, 1 / p.norm(), 0.1 * sigma) << u;
  }
}

TEST(Segment, SameEdgeNeedsDirectionDistanceAndOverlap) {
  const Vec2 a[2] = {{0, 0}, {100, 0}};
  const Vec2 near[2] = {{150, 2}, {50, 3}}, apart[2] = {{0, 10}, {100, 10}},
             turned[2] = {{50, -20}, {50, 20}}, behind[2] = {{120, 0}, {200, 0}};
  EXPECT_TRUE(sameEdge(a, near, 5, 4, 0.3));
  EXPECT_FALSE(sameEdge(a, apart, 5, 4, 0.3));
  EXPECT_FALSE(sameEdge(a, turned, 5, 4, 0.3));
  EXPECT_FALSE(sameEdge(a, behind, 5, 4, 0.3));
}

}  // namespace
}  // namespace svoscope
