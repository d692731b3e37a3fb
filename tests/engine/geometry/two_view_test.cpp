// SPDX-License-Identifier: MIT
#include "engine/geometry/two_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <functional>
#include <random>

#include "engine/geometry/two_view_decompose.h"

namespace svoscope {
namespace {

constexpr double kFocal = 500;

struct Scene {
  std::vector<Vec2> x_ref, x_cur;
  SE3 T_cur_ref;
};

using Depth = std::function<double(const Vec2& x_ref, std::mt19937& rng)>;

double generalDepth(const Vec2&, std::mt19937& rng) {
  return 2.0 + 4.0 * static_cast<double>(rng() % 1000) / 1000.0;
}
double planarDepth(const Vec2& x, std::mt19937&) {
  // Tilted plane n . p = 3.
  return 3.0 / Vec3(0.25, -0.15, 1.0).dot(x.homogeneous());
}

Scene makeScene(int count, const SE3& T, const Depth& depth, double noise_px, double outliers = 0,
                unsigned seed = 5) {
  std::mt19937 rng(seed);
  std::uniform_real_distribution<double> u(-1, 1);
  std::normal_distribution<double> n;
  Scene scene;
  scene.T_cur_ref = T;
  while (static_cast<int>(scene.x_ref.size()) < count) {
    const Vec2 x(0.6 * u(rng), 0.45 * u(rng));
    const Vec3 q = T * Vec3(depth(x, rng) * x.homogeneous());
    if (q.z() < 0.1) continue;
    Vec2 y = q.hnormalized() + noise_px / kFocal * Vec2(n(rng), n(rng));
    if (0.5 * (u(rng) + 1) < outliers) y = x + 0.12 * Vec2(u(rng), u(rng));
    scene.x_ref.push_back(x);
    scene.x_cur.push_back(y);
  }
  return scene;
}

SE3 pose(const Vec3& t, const Vec3& w = {0.02, -0.03, 0.01}) { return SE3(so3Exp(w), t); }

TwoViewResult solve(const Scene& scene) {
  TwoViewOptions options;
  options.focal = kFocal;
  return estimateTwoView(scene.x_ref, scene.x_cur, options);
}

double rotationErrorDeg(const TwoViewResult& r, const Scene& s) {
  return r.T_cur_ref.quaternion().angularDistance(s.T_cur_ref.quaternion()) * 180 / M_PI;
}
double directionErrorDeg(const TwoViewResult& r, const Scene& s) {
  const double c =
      r.T_cur_ref.translation().normalized().dot(s.T_cur_ref.translation().normalized());
  return std::acos(std::min(1.0, c)) * 180 / M_PI;
}

void expectAccurate(const Scene& scene, double rotation_deg, double direction_deg) {
  const TwoViewResult r = solve(scene);
  EXPECT_EQ(r.verdict, TwoViewVerdict::ok) << r.reason;
  EXPECT_LT(rotationErrorDeg(r, scene), rotation_deg);
  EXPECT_LT(directionErrorDeg(r, scene), direction_deg);
  EXPECT_NEAR(r.T_cur_ref.translation().norm(), 1, 1e-9);
}

TEST(TwoView, GeneralSceneSidewaysMotion) {
  const Scene s = makeScene(150, pose({0.3, 0.05, 0.02}), generalDepth, 0.3);
  expectAccurate(s, 0.2, 2.0);
  EXPECT_EQ(solve(s).model, TwoViewModel::essential);
}

TEST(TwoView, PlanarSceneIsRecognisedAsOne) {
  const Scene s = makeScene(150, pose({0.4, 0.1, 0.1}), planarDepth, 0.3);
  const TwoViewResult r = solve(s);
  EXPECT_EQ(r.model, TwoViewModel::homography);
  ASSERT_THAT(r.verdict, testing::AnyOf(TwoViewVerdict::ok, TwoViewVerdict::ambiguous));
  // The twofold ambiguity of a plane may be left to further frames, but the truth is among them.
  double best = 180;
  for (const TwoViewPose& c : r.candidates) {
    TwoViewResult one;
    one.T_cur_ref = c.T_cur_ref;
    best = std::min(best, directionErrorDeg(one, s));
  }
  EXPECT_LT(best, 3.0);
}

TEST(TwoView, ForwardMotion) {
  expectAccurate(makeScene(150, pose({0.02, 0.01, -0.4}), generalDepth, 0.3), 0.2, 2.0);
}

TEST(TwoView, FortyPercentOutliers) {
  const Scene s = makeScene(200, pose({0.3, -0.1, 0.1}), generalDepth, 0.3, 0.4);
  expectAccurate(s, 0.3, 3.0);
  EXPECT_GT(solve(s).inliers, 100);
}

TEST(TwoView, PureRotationWaits) {
  const Scene s = makeScene(150, pose(Vec3::Zero(), {0.05, 0.08, -0.1}), generalDepth, 0.3);
  const TwoViewResult r = solve(s);
  EXPECT_EQ(r.verdict, TwoViewVerdict::rotation_only) << r.reason;
  EXPECT_GT(r.disparity_px, 20);
}

TEST(TwoView, StandingCameraWaits) {
  const TwoViewResult r = solve(makeScene(150, SE3(), generalDepth, 0.3));
  EXPECT_EQ(r.verdict, TwoViewVerdict::rotation_only) << r.reason;
}

TEST(TwoView, TinyParallaxWaits) {
  // 0.005 of a depth of about 4: half a pixel.
  const TwoViewResult r = solve(makeScene(150, pose({0.005, 0, 0}), generalDepth, 0.3));
  EXPECT_THAT(r.verdict,
              testing::AnyOf(TwoViewVerdict::rotation_only, TwoViewVerdict::low_parallax));
}

TEST(TwoView, FewPointsAreRefused) {
  const TwoViewResult r = solve(makeScene(12, pose({0.3, 0, 0}), generalDepth, 0.1));
  EXPECT_EQ(r.verdict, TwoViewVerdict::too_few_tracks);
  EXPECT_THAT(r.reason, testing::HasSubstr("12 tracks"));
}

TEST(TwoView, NoCommonMotionIsRefused) {
  const TwoViewResult r = solve(makeScene(120, pose({0.3, 0, 0}), generalDepth, 0.3, 1.0));
  EXPECT_NE(r.verdict, TwoViewVerdict::ok) << r.reason;
}

TEST(TwoView, DepthsAreRightUpToScale) {
  const Scene s = makeScene(150, pose({0.4, 0.05, 0.05}), planarDepth, 0.0);
  const TwoViewResult r = solve(s);
  std::mt19937 unused;
  const double unit = s.T_cur_ref.translation().norm();
  for (std::size_t i = 0; i < s.x_ref.size(); ++i) {
    if (!r.inlier[i]) continue;
    EXPECT_NEAR(unit / r.inv_depth[i], planarDepth(s.x_ref[i], unused), 0.05);
  }
}

TEST(TwoView, RepeatedCallsAreBitIdentical) {
  const Scene s = makeScene(200, pose({0.3, -0.1, 0.1}), generalDepth, 0.5, 0.3);
  const TwoViewResult a = solve(s), b = solve(s);
  EXPECT_EQ(a.T_cur_ref.matrix(), b.T_cur_ref.matrix());
  EXPECT_EQ(a.inv_depth, b.inv_depth);
  EXPECT_EQ(a.reason, b.reason);
}

TEST(TwoView, EssentialDecompositionContainsThePose) {
  const SE3 T = pose(Vec3(0.3, -0.2, 0.5).normalized(), {0.1, 0.2, -0.1});
  double best = 1;
  for (const SE3& D : decomposeEssential(essentialMatrix(T)))
    best = std::min(best, (D.matrix() - T.matrix()).norm());
  EXPECT_LT(best, 1e-9);
}

TEST(TwoView, HomographyDecompositionContainsThePlane) {
  const SE3 T = pose({0.3, -0.2, 0.1}, {0.1, 0.2, -0.1});
  const Vec3 n = Vec3(0.2, 0.1, 1).normalized();
  Mat3 H = T.rotation() + T.translation() * n.transpose();
  H /= Eigen::JacobiSVD<Mat3>(H).singularValues()[1];
  double best = 1;
  for (const PlanePose& p : decomposeHomography(H))
    best = std::min(best, (p.T_cur_ref.rotation() - T.rotation()).norm() + (p.n_ref - n).norm());
  EXPECT_LT(best, 1e-6);
}

}  // namespace
}  // namespace svoscope
