// SPDX-License-Identifier: MIT
#include "engine/mapping/segment_refinement.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>

#include "engine/geometry/segment.h"
#include "engine/mapping/segment_seed_update.h"

namespace svoscope {
namespace {

const Vec3 kEnds[2] = {{-0.3, 0.4, 2.0}, {0.2, -0.3, 2.7}};

struct SegmentRefinementTest : testing::Test {
  Map map;
  std::mt19937 rng{3};

  SegmentRefinementTest() {
    map.camera = {640, 480, 500, 500, 319.5, 239.5};
    for (int i = 0; i < 4; ++i) {
      Keyframe& k = map.keyframes[i];
      k.id = i;
      k.T_cam_world = SE3(so3Exp({0.01 * i, -0.02 * i, 0.02}), {-0.12 * i, 0.05 * i, 0.02 * i});
    }
  }
  /// Lines seen with noise across them; only a part of the segment, another in each view.
  SegmentLandmark observe(double noise) {
    std::normal_distribution<double> n(0, noise);
    SegmentLandmark s;
    for (int e = 0; e < 2; ++e) s.p_world[e] = kEnds[e];
    for (const auto& [id, k] : map.keyframes) {
      Vec2 px[2];
      for (int e = 0; e < 2; ++e) {
        const double t = e ? 1 - 0.05 * id : 0.04 * id;
        px[e] = map.camera.project(k.T_cam_world * Vec3((1 - t) * kEnds[0] + t * kEnds[1]));
      }
      const Vec2 normal = lineThrough(px[0], px[1]).normal;
      for (Vec2& p : px) p += n(rng) * normal;
      s.views.push_back({id, makeSegmentAnchor(px[0], px[1], map.camera, 0)});
    }
    return s;
  }
};

TEST_F(SegmentRefinementTest, JacobiansAgreeWithFiniteDifferences) {
  SegmentLandmark s = observe(0.5);
  s.prior[0] = 0.45;
  s.prior_sigma[0] = 0.03;
  const Vec3 p = kEnds[0] + Vec3(0.02, -0.03, 0.05);
  const EndPointResiduals at = endPointResiduals(s, 0, p, map, 0.5);
  ASSERT_EQ(at.r.size(), 5);
  for (int k = 0; k < 3; ++k) {
    const Vec3 d = 1e-6 * Vec3::Unit(k);
    const Eigen::VectorXd slope =
        (endPointResiduals(s, 0, p + d, map, 0.5).r - endPointResiduals(s, 0, p - d, map, 0.5).r) /
        2e-6;
    // The weight of an extrapolated line moves a little with the point; it is held in the Jacobian.
    for (Eigen::Index i = 0; i < at.r.size(); ++i)
      EXPECT_NEAR(at.J(i, k), slope[i], 0.02 * at.J.row(i).norm()) << i << k;
  }
}

TEST_F(SegmentRefinementTest, MovesAcrossTheSegmentOnlyAndFindsIt) {
  SegmentLandmark s = observe(0.0);
  const Vec3 along = (kEnds[1] - kEnds[0]).normalized();
  const Vec3 off = 0.04 * along.unitOrthogonal();
  s.p_world[0] += off;
  s.p_world[1] += off;
  const Vec3 start = s.p_world[0];
  EXPECT_TRUE(refineSegment(s, map, 0.5, 10));
  EXPECT_NEAR((s.p_world[0] - start).dot(along), 0, 1e-9);
  for (int e = 0; e < 2; ++e) EXPECT_LT((s.p_world[e] - kEnds[e]).cross(along).norm(), 1e-5);
}

/// The scatter of refined end points against the covariance the refinement reports.
TEST_F(SegmentRefinementTest, CovarianceAgreesWithMonteCarlo) {
  constexpr double kNoise = 0.3;
  constexpr int kRuns = 1500;
  const Vec3 along = (kEnds[1] - kEnds[0]).normalized();
  for (int e = 0; e < 2; ++e) {
    Mat3 scatter = Mat3::Zero(), predicted = Mat3::Zero();
    for (int i = 0; i < kRuns; ++i) {
      SegmentLandmark s = observe(kNoise);
      refineSegment(s, map, kNoise, 10);
      const Vec3 d = s.p_world[e] - kEnds[e];
      scatter += d * d.transpose() / kRuns;
      predicted += s.covariance[e] / kRuns;
    }
    EXPECT_NEAR(std::sqrt(scatter.trace() / predicted.trace()), 1, 0.1);
    EXPECT_NEAR(along.dot(scatter * along), 0, 1e-9);
    // The worst direction, depth, agrees too.
    const Vec3 depth = Eigen::SelfAdjointEigenSolver<Mat3>(predicted).eigenvectors().col(2);
    EXPECT_NEAR(std::sqrt(depth.dot(scatter * depth) / depth.dot(predicted * depth)), 1, 0.1);
  }
}

}  // namespace
}  // namespace svoscope
