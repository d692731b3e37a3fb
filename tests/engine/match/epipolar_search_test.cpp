// SPDX-License-Identifier: MIT
#include "engine/match/epipolar_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/plane_scene.h"

namespace svoscope {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

/// A reference view at the origin and a current view of a textured plane.
struct TwoViews {
  TwoViews(const Vec3& normal, const SE3& T)
      : scene(test::smallCamera(), normal, 2, 0.06),
        T_cur_ref(T),
        ref(scene.pyramid(SE3(), 4)),
        cur(scene.pyramid(T, 4)) {}

  double truth(const Vec2& px) const { return scene.inverseDistance(SE3(), px); }

  EpipolarQuery query(const Vec2& px, double mu, double sigma) const {
    EpipolarQuery q;
    q.ref = ref.get();
    q.cur = cur.get();
    q.camera = scene.camera();
    q.T_cur_ref = T_cur_ref;
    q.px_ref = px;
    q.f_ref = scene.camera().bearing(px);
    q.mu = mu;
    q.sigma = sigma;
    return q;
  }

  test::PlaneScene scene;
  SE3 T_cur_ref;
  PyramidPtr ref, cur;
};

const SE3 kSideways(so3Exp(Vec3(0.01, -0.02, 0.01)), Vec3(-0.15, 0.02, 0.01));

void expectDepths(const TwoViews& views, double least_matched) {
  int matched = 0, tried = 0, within = 0;
  for (const Vec2& px : test::gridPixels(views.scene.camera(), 24, 40)) {
    const double truth = views.truth(px);
    const EpipolarMatch m = searchEpipolar(views.query(px, 1.15 * truth, 0.1), {}, {});
    if (m.outcome == SearchOutcome::out_of_view) continue;
    ++tried;
    if (m.outcome != SearchOutcome::matched) continue;
    ++matched;
    within += std::abs(m.inv_distance - truth) < m.tau;
    EXPECT_GT(m.tau, 0);
  }
  EXPECT_GT(tried, 50);
  EXPECT_GT(matched, least_matched * tried);
  EXPECT_GT(within, 0.97 * matched);
}

TEST(EpipolarSearch, FindsTheInverseDistanceOfAFrontoParallelPlane) {
  expectDepths(TwoViews(Vec3::UnitZ(), kSideways), 0.9);
}

TEST(EpipolarSearch, FindsTheInverseDistanceOfASlantedPlane) {
  expectDepths(TwoViews(Vec3(0.5, 0.2, 1), kSideways), 0.8);
}

TEST(EpipolarSearch, WorksForForwardMotion) {
  expectDepths(
      TwoViews(Vec3::UnitZ(), SE3(Eigen::Quaterniond::Identity(), Vec3(0.03, 0.02, -0.35))), 0.6);
}

TEST(EpipolarSearch, LooksNoFurtherThanSigmasAllow) {
  const TwoViews views(Vec3::UnitZ(), kSideways);
  int found_narrow = 0, found_wide = 0, tried = 0;
  for (const Vec2& px : test::gridPixels(views.scene.camera(), 40, 60)) {
    const double truth = views.truth(px), sigma = 0.05;
    // The truth lies 8 sigma from the belief, 18 px along the line.
    const auto found = [&](double sigmas) {
      EpipolarParameters p;
      p.search_sigmas = sigmas;
      const EpipolarMatch m = searchEpipolar(views.query(px, truth + 8 * sigma, sigma), p, {});
      return m.outcome == SearchOutcome::matched && std::abs(m.inv_distance - truth) < 0.02;
    };
    ++tried;
    found_narrow += found(2);
    found_wide += found(9);
  }
  EXPECT_EQ(found_narrow, 0);
  EXPECT_GT(found_wide, 0.8 * tried);
}

TEST(EpipolarSearch, ShortLinesAreAlignedWithoutAScan) {
  const TwoViews views(Vec3::UnitZ(), kSideways);
  const Vec2 px(160, 120);
  const EpipolarMatch m = searchEpipolar(views.query(px, views.truth(px), 0.002), {}, {});
  ASSERT_EQ(m.outcome, SearchOutcome::matched);
  EXPECT_EQ(m.score, 0);  // no scan
  EXPECT_NEAR(m.inv_distance, views.truth(px), m.tau);
}

TEST(EpipolarSearch, TellsWhyThereIsNoMeasurement) {
  const Vec2 px(160, 120);
  const TwoViews turned(Vec3::UnitZ(), SE3(so3Exp(Vec3(0, 1.5, 0)), Vec3::Zero()));
  EXPECT_EQ(searchEpipolar(turned.query(px, 0.5, 0.1), {}, {}).outcome, SearchOutcome::out_of_view);
  const TwoViews still(Vec3::UnitZ(), SE3());
  EXPECT_EQ(searchEpipolar(still.query(px, 0.5, 0.1), {}, {}).outcome, SearchOutcome::low_parallax);
  const TwoViews barely(Vec3::UnitZ(), SE3(Eigen::Quaterniond::Identity(), Vec3(-0.001, 0, 0)));
  EXPECT_EQ(searchEpipolar(barely.query(px, 0.5, 0.1), {}, {}).outcome,
            SearchOutcome::low_parallax);
  // A patch of another plane: nothing on the line looks like it.
  TwoViews other(Vec3::UnitZ(), kSideways);
  other.cur = buildPyramid(cv::Mat(240, 320, CV_8UC1, cv::Scalar(128)), 4);
  EXPECT_EQ(searchEpipolar(other.query(px, 0.5, 0.1), {}, {}).outcome, SearchOutcome::no_match);
}

TEST(EpipolarSearch, EdgeletsAlongTheLineAreRefused) {
  const TwoViews views(Vec3::UnitZ(), SE3(Eigen::Quaterniond::Identity(), Vec3(-0.15, 0, 0)));
  const Vec2 px(160, 120);
  EpipolarQuery q = views.query(px, views.truth(px), 0.05);
  q.type = FeatureType::edgelet;
  q.gradient_dir = Vec2::UnitY();
  EXPECT_EQ(searchEpipolar(q, {}, {}).outcome, SearchOutcome::edge_parallel);
  q.gradient_dir = Vec2::UnitX();
  const EpipolarMatch m = searchEpipolar(q, {}, {});
  ASSERT_EQ(m.outcome, SearchOutcome::matched);
  EXPECT_NEAR(m.px.y(), px.y(), 1e-3);  // slides along the line only
  EXPECT_NEAR(m.inv_distance, views.truth(px), m.tau);
  EXPECT_GT(m.gradient_dir.dot(Vec2::UnitX()), 0.999);
}

TEST(EpipolarSearch, BadNumbersAreRefused) {
  const TwoViews views(Vec3::UnitZ(), kSideways);
  const Vec2 px(160, 120);
  const auto outcome = [&](double mu, double sigma) {
    return searchEpipolar(views.query(px, mu, sigma), {}, {}).outcome;
  };
  EXPECT_NE(outcome(kNan, 0.1), SearchOutcome::matched);
  EXPECT_NE(outcome(0.5, kNan), SearchOutcome::matched);
  EXPECT_NE(outcome(kInf, 0.1), SearchOutcome::matched);
  EpipolarQuery q = views.query(px, 0.5, 0.1);
  q.T_cur_ref = SE3(Eigen::Quaterniond::Identity(), Vec3(kNan, 0, 0));
  EXPECT_NE(searchEpipolar(q, {}, {}).outcome, SearchOutcome::matched);
  for (const double sigma : {1e3, 1e9, 1e20}) {
    const EpipolarMatch m = searchEpipolar(views.query(px, 0.5, sigma), {}, {});
    if (m.outcome == SearchOutcome::matched) {
      EXPECT_TRUE(std::isfinite(m.inv_distance) && std::isfinite(m.tau));
    }
  }
}

TEST(EpipolarSearch, BeliefsAtInfinityAreSearched) {
  const TwoViews views(Vec3::UnitZ(), kSideways);
  const Vec2 px(160, 120);
  const EpipolarMatch m = searchEpipolar(views.query(px, 0.0, 0.25), {}, {});
  ASSERT_EQ(m.outcome, SearchOutcome::matched);
  EXPECT_NEAR(m.inv_distance, views.truth(px), m.tau);
}

TEST(EpipolarSearch, TheProfileIsLowestAtTheTruth) {
  const TwoViews views(Vec3::UnitZ(), kSideways);
  const Vec2 px(160, 120);
  const auto profile = scoreProfile(views.query(px, views.truth(px) * 1.1, 0.1), {});
  ASSERT_GT(profile.size(), 8u);
  const auto best =
      std::min_element(profile.begin(), profile.end(),
                       [](const auto& a, const auto& b) { return a.score < b.score; });
  EXPECT_NEAR(best->inv_distance, views.truth(px), 0.02);
  for (std::size_t i = 1; i < profile.size(); ++i)
    EXPECT_LE(profile[i - 1].inv_distance, profile[i].inv_distance);
}

TEST(TriangulateInverseDistance, InvertsProjection) {
  const Pinhole camera = test::smallCamera();
  const Vec3 f = camera.bearing({90, 170});
  for (const double z : {2.0, 0.5, 0.01, 0.0}) {
    const Vec3 p = kSideways.quaternion() * f + z * kSideways.translation();
    EXPECT_NEAR(triangulateInverseDistance(camera, kSideways, f, camera.project(p)), z, 1e-10);
  }
  EXPECT_LE(triangulateInverseDistance(camera, SE3(), f, {90, 170}), 0);  // no baseline
}

/// |d inverse distance / d px| along the epipolar line, numerically.
double numericSigma(const Pinhole& camera, const SE3& T, const Vec3& f, double z) {
  const auto at = [&](double inverse) {
    return camera.project(T.quaternion() * f + inverse * T.translation());
  };
  const Vec2 along = (at(z + 1e-6) - at(z - 1e-6)).normalized(), px = at(z);
  constexpr double h = 1e-3;  // px
  return std::abs(triangulateInverseDistance(camera, T, f, px + h * along) -
                  triangulateInverseDistance(camera, T, f, px - h * along)) /
         (2 * h);
}

TEST(ParallaxAt, IsTheAngleBetweenTheRays) {
  const SE3 T_cur_ref(so3Exp(Vec3(0.1, -0.2, 0.05)), Vec3(0.3, -0.1, 0.05));
  const Vec3 f = Vec3(0.1, 0.2, 1).normalized();
  const Vec3 c = T_cur_ref.inverse().translation(), p = f / 0.4;
  EXPECT_NEAR(parallaxAt(T_cur_ref, f, 0.4), std::acos(p.normalized().dot((p - c).normalized())),
              1e-12);
  EXPECT_NEAR(parallaxAt(SE3(so3Exp(Vec3(0.1, 0, 0)), Vec3::Zero()), f, 0.4), 0, 1e-12);
  EXPECT_NEAR(parallaxAt(T_cur_ref, f, 0), 0, 1e-12);
}

TEST(InverseDistanceSigma, IsWhatOnePixelAlongTheLineChanges) {
  const Pinhole camera = test::smallCamera();
  for (const Vec2& px : {Vec2(160, 120), Vec2(100, 90), Vec2(220, 150)}) {
    const Vec3 f = camera.bearing(px);
    for (const double z : {1.0, 0.5, 0.2, 0.1, 0.02, 0.001}) {
      for (const SE3& T : {kSideways, SE3(so3Exp(Vec3(0, 0.1, 0)), Vec3(0.3, 0.1, -0.1))}) {
        const double sigma = inverseDistanceSigma(T, f, z, 1, camera.focal());
        const double numeric = numericSigma(camera, T, f, z);
        // A pixel is 1 / focal radians on the axis, down to cos^2 of that off the axis.
        const Vec3 seen = T.quaternion() * f + z * T.translation();
        const double cosine = seen.z() / seen.norm();
        EXPECT_GT(sigma / numeric, 0.98) << "inverse distance " << z << " at " << px.transpose();
        EXPECT_LT(sigma / numeric, 1.02 / (cosine * cosine))
            << "inverse distance " << z << " at " << px.transpose();
      }
    }
  }
}

TEST(InverseDistanceSigma, GrowsWithNoiseAndIsHugeWithoutBaseline) {
  const Vec3 f = Vec3::UnitZ();
  const double one = inverseDistanceSigma(kSideways, f, 0.5, 1, 300);
  EXPECT_NEAR(inverseDistanceSigma(kSideways, f, 0.5, 2, 300) / one, 2, 0.02);
  EXPECT_GE(inverseDistanceSigma(SE3(), f, 0.5, 1, 300), 1e3);
  const double along =
      inverseDistanceSigma(SE3(Eigen::Quaterniond::Identity(), Vec3(0, 0, -0.1)), f, 0.5, 1, 300);
  EXPECT_TRUE(std::isfinite(along));
  EXPECT_GT(along, 1);  // motion towards the point: no information
}

}  // namespace
}  // namespace svoscope
