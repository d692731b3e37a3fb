// SPDX-License-Identifier: MIT
#include "engine/geometry/triangulation.h"

#include <gtest/gtest.h>

#include <random>

namespace svoscope {
namespace {

SE3 motion(const Vec3& t, const Vec3& w) { return SE3(so3Exp(w), t); }

TEST(Triangulation, ExactViewsGiveTheExactPoint) {
  std::mt19937 rng(1);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int i = 0; i < 100; ++i) {
    const SE3 T = motion({u(rng), u(rng), 0.5 * u(rng)}, 0.2 * Vec3(u(rng), u(rng), u(rng)));
    const Vec3 p(u(rng), u(rng), 4 + 2 * u(rng));
    const TwoRayPoint found = triangulate(T, p.hnormalized(), (T * p).hnormalized());
    EXPECT_LT((found.point(p.hnormalized()) - p).norm(), 1e-8);
    EXPECT_TRUE(found.in_front);
    EXPECT_LT(found.error, 1e-10);
  }
}

TEST(Triangulation, ParallaxIsTheAngleBetweenTheRays) {
  // Point at distance 2 seen from two sides, one unit apart: atan(1/2).
  const TwoRayPoint p = triangulate(motion({-1, 0, 0}, Vec3::Zero()), {0, 0}, {-0.5, 0});
  EXPECT_NEAR(p.parallax, std::atan(0.5), 1e-12);
  EXPECT_NEAR(p.inv_depth, 0.5, 1e-12);
}

TEST(Triangulation, SigmaPredictsTheScatterOfTheDepth) {
  std::mt19937 rng(2);
  std::normal_distribution<double> n;
  const SE3 T = motion({0.3, 0.1, 0.2}, {0.02, -0.05, 0.01});
  const Vec3 p(0.4, -0.3, 3);
  const double noise = 1e-3;
  double sum = 0, sigma = 0;
  constexpr int kTrials = 4000;
  for (int i = 0; i < kTrials; ++i) {
    const Vec2 x = (T * p).hnormalized() + noise * Vec2(n(rng), n(rng));
    const TwoRayPoint found = triangulate(T, p.hnormalized(), x);
    sum += (found.inv_depth - 1 / p.z()) * (found.inv_depth - 1 / p.z());
    sigma = found.sigma;
  }
  EXPECT_NEAR(std::sqrt(sum / kTrials), sigma * noise, 0.05 * sigma * noise);
}

TEST(Triangulation, APointBehindIsNotInFront) {
  const SE3 T = motion({-1, 0, 0}, Vec3::Zero());
  EXPECT_FALSE(triangulate(T, {0, 0}, {0.2, 0}).in_front);
}

TEST(Triangulation, WithoutTranslationNothingIsKnown) {
  const TwoRayPoint p = triangulate(SE3(), {0.1, 0.2}, {0.1, 0.2});
  EXPECT_FALSE(p.in_front);
  EXPECT_FALSE(std::isfinite(p.sigma));
}

TEST(Triangulation, UnitPlaneJacobianMatchesFiniteDifferences) {
  const Vec3 p(0.3, -0.7, 2.1);
  constexpr double h = 1e-6;
  const Mat23 J = unitPlaneJacobian(p);
  for (int k = 0; k < 3; ++k) {
    const Vec2 d = ((p + h * Vec3::Unit(k)).hnormalized() - (p - h * Vec3::Unit(k)).hnormalized());
    EXPECT_LT((J.col(k) - d / (2 * h)).norm(), 1e-9);
  }
}

TEST(Triangulation, RefinementReachesTheTruthAndIgnoresNothing) {
  std::mt19937 rng(3);
  std::uniform_real_distribution<double> u(-1, 1);
  const Vec3 truth(0.5, 0.2, 4);
  std::vector<PointView> views;
  for (int k = 0; k < 5; ++k) {
    PointView view;
    view.T_cam_world = motion({u(rng), u(rng), 0.3 * u(rng)}, 0.1 * Vec3(u(rng), u(rng), u(rng)));
    view.x = (view.T_cam_world * truth).hnormalized();
    views.push_back(view);
  }
  const RefinedPoint found = refinePoint(truth + Vec3(0.3, -0.2, 0.8), views);
  EXPECT_TRUE(found.converged);
  EXPECT_LT((found.p_world - truth).norm(), 1e-8);
  EXPECT_LT(found.rms, 1e-9);
}

TEST(Triangulation, RefinementRefusesAPointBehindACamera) {
  PointView view;
  const RefinedPoint found = refinePoint({0, 0, -1}, {view});
  EXPECT_FALSE(found.converged);
}

}  // namespace
}  // namespace svoscope
