// SPDX-License-Identifier: MIT
#include "engine/geometry/two_view_bundle.h"

#include <gtest/gtest.h>

#include <random>

namespace svoscope {
namespace {

constexpr double kFocal = 500;

/// Points of depth 2 to 4 and three frames along a curved path, last |t| = 1.
MultiViewProblem truth(int points, bool edgelets) {
  std::mt19937 rng(4);
  std::uniform_real_distribution<double> u(-1, 1);
  MultiViewProblem p;
  for (double s : {0.4, 0.7, 1.0})
    p.T_frame_ref.emplace_back(so3Exp(Vec3(0.02, -0.1 * s, 0.03 * s * s)),
                               s * Vec3(0.9, 0.3 * s, 0.1).normalized());
  for (int i = 0; i < points; ++i) {
    p.x_ref.emplace_back(0.5 * u(rng), 0.4 * u(rng));
    p.inv_depth.push_back(1 / (10 + 5 * u(rng)));
    const bool edgelet = edgelets && i % 3 == 0;
    p.normal_ref.push_back(edgelet ? Vec2(u(rng), u(rng)).normalized() : Vec2::Zero());
  }
  for (const SE3& T : p.T_frame_ref) {
    p.x.emplace_back();
    for (int i = 0; i < points; ++i)
      p.x.back().push_back(
          (T.quaternion() * p.x_ref[i].homogeneous() + p.inv_depth[i] * T.translation())
              .hnormalized());
  }
  return p;
}

MultiViewProblem disturbed(MultiViewProblem p) {
  std::mt19937 rng(6);
  std::normal_distribution<double> n;
  for (SE3& T : p.T_frame_ref) {
    Vec6 xi;
    for (int k = 0; k < 6; ++k) xi[k] = (k < 3 ? 0.05 : 0.003) * n(rng);
    T = SE3::exp(xi) * T;
  }
  for (double& d : p.inv_depth) d *= 1 + 0.1 * n(rng);
  return p;
}

double poseError(const MultiViewProblem& a, const MultiViewProblem& b) {
  double worst = 0;
  for (std::size_t k = 0; k < a.T_frame_ref.size(); ++k)
    worst = std::max(worst, (a.T_frame_ref[k].inverse() * b.T_frame_ref[k]).log().norm());
  return worst;
}

TEST(TwoViewBundle, JacobiansMatchFiniteDifferences) {
  const SE3 T(so3Exp(Vec3(0.1, -0.2, 0.05)), Vec3(0.4, 0.2, -0.3));
  const Vec2 x_ref(0.3, -0.2), x(0.25, -0.1);
  const double rho = 0.4;
  constexpr double h = 1e-6;
  const MultiViewResidual at = multiViewResidual(T, x_ref, rho, x, kFocal);
  for (int k = 0; k < 6; ++k) {
    const Vec6 d = h * Vec6::Unit(k);
    const Vec2 numeric = (multiViewResidual(SE3::exp(d) * T, x_ref, rho, x, kFocal).r -
                          multiViewResidual(SE3::exp(-d) * T, x_ref, rho, x, kFocal).r) /
                         (2 * h);
    EXPECT_LT((at.J_pose.col(k) - numeric).norm(), 1e-4 * (1 + numeric.norm())) << k;
  }
  const Vec2 numeric = (multiViewResidual(T, x_ref, rho + h, x, kFocal).r -
                        multiViewResidual(T, x_ref, rho - h, x, kFocal).r) /
                       (2 * h);
  EXPECT_LT((at.J_inv_depth - numeric).norm(), 1e-4 * numeric.norm());
}

TEST(TwoViewBundle, FindsTheTruthFromADisturbedStart) {
  for (bool edgelets : {false, true}) {
    const MultiViewProblem exact = truth(80, edgelets);
    MultiViewProblem p = disturbed(exact);
    MultiViewOptions options;
    options.focal = kFocal;
    options.max_iterations = 40;
    const MultiViewSummary s = refineMultiView(p, options);
    EXPECT_TRUE(s.converged);
    EXPECT_LT(s.scale_px, 0.02);
    EXPECT_LT(poseError(p, exact), 2e-3) << "edgelets " << edgelets;
  }
}

TEST(TwoViewBundle, OutliersAndMissingMeasurementsDoNotMatter) {
  const MultiViewProblem exact = truth(100, false);
  MultiViewProblem p = disturbed(exact);
  for (int i = 0; i < 15; ++i) p.x[1][i] += Vec2(0.03, -0.02);
  for (int i = 20; i < 40; ++i) p.x[0][i] = notMeasured();
  MultiViewOptions options;
  options.focal = kFocal;
  options.max_iterations = 40;
  const MultiViewSummary s = refineMultiView(p, options);
  EXPECT_LT(poseError(p, exact), 5e-3);
  EXPECT_GT(s.point_px[0], 2.0);
  EXPECT_LT(s.point_px[50], 0.3);
}

TEST(TwoViewBundle, PosesOnlyKeepsTheDepths) {
  const MultiViewProblem exact = truth(50, false);
  MultiViewProblem p = disturbed(exact);
  p.inv_depth = exact.inv_depth;
  MultiViewOptions options;
  options.focal = kFocal;
  options.poses_only = true;
  refineMultiView(p, options);
  EXPECT_EQ(p.inv_depth, exact.inv_depth);
  EXPECT_LT(poseError(p, exact), 1e-3);
}

TEST(TwoViewBundle, UncertaintyPredictsTheScatter) {
  const MultiViewProblem exact = truth(60, false);
  MultiViewOptions options;
  options.focal = kFocal;
  std::mt19937 rng(8);
  std::normal_distribution<double> n;
  std::vector<double> ratio;
  for (int trial = 0; trial < 30; ++trial) {
    MultiViewProblem p = exact;
    for (auto& frame : p.x)
      for (Vec2& x : frame) x += 0.2 / kFocal * Vec2(n(rng), n(rng));
    const MultiViewSummary s = refineMultiView(p, options);
    double scale = 0;
    for (std::size_t i = 0; i < 60; ++i) scale += p.inv_depth[i] / exact.inv_depth[i] / 60;
    for (std::size_t i = 0; i < 60; ++i)
      ratio.push_back(std::abs(p.inv_depth[i] / scale - exact.inv_depth[i]) /
                      (0.2 * s.sigma_inv_depth[i]));
  }
  std::sort(ratio.begin(), ratio.end());
  EXPECT_NEAR(ratio[ratio.size() / 2], 0.674, 0.25);  // median of |N(0, 1)|
}

}  // namespace
}  // namespace svoscope
