// SPDX-License-Identifier: MIT
#include "engine/tracking/pose_refinement.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/plane_scene.h"

namespace svoscope {
namespace {

const SE3 kTruth(so3Exp(Vec3(0.1, -0.2, 0.05)), Vec3(0.3, -0.1, 0.2));
const SE3 kStart =
    SE3::exp((Vec6() << 0.02, -0.015, 0.02, 0.005, 0.004, -0.006).finished()) * kTruth;

struct Scene {
  explicit Scene(int count, unsigned seed = 1) : rng(seed) {
    const Pinhole camera = test::smallCamera();
    for (int i = 0; i < count; ++i) {
      PoseObservation o;
      o.px = Vec2(uniform(10, 310), uniform(10, 230));
      o.p_world = kTruth.inverse() * (camera.bearing(o.px) * uniform(1.5, 4));
      observations.push_back(o);
    }
  }
  double uniform(double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(rng);
  }
  void addNoise(double sigma) {
    std::normal_distribution<double> n(0, sigma);
    for (PoseObservation& o : observations) o.px += Vec2(n(rng), n(rng));
  }
  void makeOutliers(double share) {
    for (std::size_t i = 0;
         i < static_cast<std::size_t>(share * static_cast<double>(observations.size())); ++i)
      observations[i].px = Vec2(uniform(10, 310), uniform(10, 230));
  }
  /// Edgelets with gradient direction at `degrees`, displaced along the edge by `slide` px.
  void makeEdgelets(double degrees, double slide) {
    const Vec2 g(std::cos(degrees * M_PI / 180), std::sin(degrees * M_PI / 180));
    for (PoseObservation& o : observations) {
      o.type = FeatureType::edgelet;
      o.gradient_dir = g;
      o.px += slide * Vec2(-g.y(), g.x());
    }
  }
  std::mt19937 rng;
  std::vector<PoseObservation> observations;
};

PoseRefinementResult refine(const Scene& s, const SE3& start = kStart,
                            const PoseRefinementParameters& p = {}) {
  return refinePose(test::smallCamera(), s.observations, start, p);
}

double distance(const SE3& T) {
  return (T.inverse().translation() - kTruth.inverse().translation()).norm();
}

TEST(PoseRefinement, IsExactWithoutNoise) {
  const PoseRefinementResult r = refine(Scene(60));
  ASSERT_TRUE(r.ok);
  EXPECT_LT(distance(r.T_cam_world), 1e-7);
  EXPECT_EQ(r.inliers, 60);
  EXPECT_LT(r.median_px, 1e-5);
}

TEST(PoseRefinement, DoubtOfDepthLeavesTheErrorAcross) {
  // All points are believed at a wrong depth; depth_px says along which line that moves them.
  const Pinhole camera = test::smallCamera();
  const SE3 T_ref(so3Exp(Vec3(0.02, 0.03, 0)), Vec3(0.5, 0.2, -0.3));
  Scene told(80), untold(80);
  for (std::size_t i = 0; i < told.observations.size(); ++i) {
    PoseObservation& o = told.observations[i];
    const Vec3 q = T_ref * o.p_world;
    const Vec3 wrong = T_ref.inverse() * (q * (i % 2 ? 1.25 : 0.85));
    o.depth_px = 2 * (camera.project(kTruth * wrong) - camera.project(kTruth * o.p_world));
    o.p_world = untold.observations[i].p_world = wrong;
  }
  const double with = distance(refine(told).T_cam_world),
               without = distance(refine(untold).T_cam_world);
  EXPECT_LT(with, 0.3 * without);
}

TEST(PoseRefinement, AnEdgeletWithUnknownDepthAcrossItsGradientSaysNothing) {
  Scene s(60);
  s.makeEdgelets(30, 0);
  for (std::size_t i = 0; i < s.observations.size(); i += 2)
    s.observations[i].gradient_dir = Vec2(0.5, -0.866).normalized();
  Scene moved = s;
  moved.observations[0].px += 30 * moved.observations[0].gradient_dir;
  s.observations[0].depth_px = moved.observations[0].depth_px =
      1e6 * s.observations[0].gradient_dir;
  EXPECT_LT((refine(s).T_cam_world.inverse() * refine(moved).T_cam_world).log().norm(), 1e-6);
}

TEST(PoseRefinement, BearsThirtyPercentOutliers) {
  Scene s(150);
  s.addNoise(0.3);
  s.makeOutliers(0.3);
  const PoseRefinementResult r = refine(s);
  ASSERT_TRUE(r.ok);
  EXPECT_LT(distance(r.T_cam_world), 0.004);
  EXPECT_LT(test::angleDeg(r.T_cam_world, kTruth), 0.1);
  EXPECT_GE(r.inliers, 100);
  for (std::size_t i = 0; i < r.inlier.size(); ++i) EXPECT_EQ(r.inlier[i] != 0, r.error_px[i] <= 2);
}

/// Tukey's cost of a pose at a fixed scale.
double cost(const Scene& s, const SE3& T, double scale) {
  const Pinhole camera = test::smallCamera();
  double sum = 0;
  for (const PoseObservation& o : s.observations) {
    Vec2 e = o.px - camera.project(T * o.p_world);
    double sigma = scale * (1 << o.level);
    if (o.type == FeatureType::edgelet) {
      e = Vec2(o.gradient_dir.dot(e), 0);
      sigma *= PoseRefinementParameters().edgelet_sigma;
    }
    const double u = std::min(1.0, e.norm() / sigma / 4.685);
    sum += 1 - std::pow(1 - u * u, 3);
  }
  return sum;
}

TEST(PoseRefinement, EndsInAMinimumOfTheRobustCost) {
  Scene s(100);
  s.addNoise(0.5);
  s.makeOutliers(0.1);
  for (std::size_t i = 40; i < 60; ++i) {
    s.observations[i].type = FeatureType::edgelet;
    s.observations[i].gradient_dir = Vec2(0.6, 0.8);
  }
  for (std::size_t i = 60; i < 80; ++i) s.observations[i].level = 1;
  PoseRefinementParameters p;
  p.max_iterations = 40;
  const PoseRefinementResult r = refine(s, kStart, p);
  ASSERT_TRUE(r.ok);
  const double least = cost(s, r.T_cam_world, r.scale_px);
  for (int k = 0; k < 6; ++k) {
    for (const double h : {-1e-3, -1e-4, 1e-4, 1e-3})
      EXPECT_LT(least, cost(s, SE3::exp(h * Vec6::Unit(k)) * r.T_cam_world, r.scale_px))
          << k << ' ' << h;
  }
}

TEST(PoseRefinement, EdgeletsConstrainAcrossTheEdgeOnly) {
  Scene s(80);
  for (std::size_t i = 0; i < s.observations.size(); ++i) {
    PoseObservation& o = s.observations[i];
    o.type = FeatureType::edgelet;
    o.gradient_dir = i % 2 ? Vec2::UnitX() : Vec2::UnitY();
    o.px +=
        (i % 3 - 1.0) * 5 * Vec2(-o.gradient_dir.y(), o.gradient_dir.x());  // slid along the edge
  }
  const PoseRefinementResult r = refine(s);
  ASSERT_TRUE(r.ok);
  EXPECT_LT(distance(r.T_cam_world), 1e-6);
  EXPECT_EQ(r.inliers, 80);
}

TEST(PoseRefinement, EdgeletsOfOneDirectionLeaveTheRestAtThePrediction) {
  Scene s(80);
  s.makeEdgelets(0, 3);
  s.addNoise(0.2);
  const PoseRefinementResult r = refine(s);
  ASSERT_TRUE(r.T_cam_world.finite());
  EXPECT_LT(distance(r.T_cam_world), 0.15);  // the prediction is 0.03 off
  EXPECT_LT(test::angleDeg(r.T_cam_world, kTruth), 3);
}

TEST(PoseRefinement, PointsAtOnePlaceLeaveTheRestAtThePrediction) {
  Scene s(30);
  for (PoseObservation& o : s.observations) o = s.observations[0];
  const PoseRefinementResult r = refine(s);
  ASSERT_TRUE(r.T_cam_world.finite());
  EXPECT_LT(distance(r.T_cam_world), 0.15);
}

TEST(PoseRefinement, FewerThanSixObservationsAreRefused) {
  const PoseRefinementResult r = refine(Scene(5));
  EXPECT_FALSE(r.ok);
  EXPECT_EQ(r.T_cam_world.matrix(), kStart.matrix());
  EXPECT_EQ(r.inlier.size(), 5u);
  EXPECT_FALSE(refine(Scene(0)).ok);
}

TEST(PoseRefinement, PointsBehindTheCameraAreOutliers) {
  Scene s(40);
  const Vec3 behind = kTruth.inverse() * Vec3(0, 0, -2);
  for (int i = 0; i < 5; ++i) s.observations[static_cast<std::size_t>(i)].p_world = behind;
  const PoseRefinementResult r = refine(s);
  ASSERT_TRUE(r.ok);
  EXPECT_EQ(r.inliers, 35);
  EXPECT_LT(distance(r.T_cam_world), 1e-6);
}

TEST(PoseRefinement, TheInlierLimitDoublesPerLevel) {
  Scene s(40);
  s.observations[0].px += Vec2(3, 0);
  s.observations[1].px += Vec2(3, 0);
  s.observations[1].level = 1;
  const PoseRefinementResult r = refine(s);
  EXPECT_FALSE(r.inlier[0]);
  EXPECT_TRUE(r.inlier[1]);
}

}  // namespace
}  // namespace svoscope
