// SPDX-License-Identifier: MIT
#include "engine/tracking/sparse_alignment.h"

#include <gtest/gtest.h>

#include <limits>
#include <opencv2/core.hpp>

#include "tests/support/plane_scene.h"

namespace svoscope {
namespace {

const SE3 kMotion(so3Exp(Vec3(0.006, -0.012, 0.008)), Vec3(-0.03, 0.02, 0.04));

test::PlaneScene scene() { return {test::smallCamera(), Vec3(0.3, -0.2, 1), 2, 0.09}; }

std::vector<AlignmentPatch> patchesOf(const test::PlaneScene& s, int step = 24) {
  std::vector<AlignmentPatch> patches;
  for (const Vec2& px : test::gridPixels(s.camera(), step, 30))
    patches.push_back({px, s.point(SE3(), px)});
  return patches;
}

SparseAlignmentParameters fine() {
  SparseAlignmentParameters p;
  p.min_level = 0;
  return p;
}

void expectMotion(const SparseAlignmentResult& r, const SE3& truth, double deg, double distance) {
  ASSERT_TRUE(r.ok);
  EXPECT_LT(test::angleDeg(r.T_cur_ref, truth), deg);
  EXPECT_LT((r.T_cur_ref.translation() - truth.translation()).norm(), distance);
}

TEST(PixelTwistJacobian, AgreesWithFiniteDifferences) {
  const Pinhole camera = test::smallCamera();
  constexpr double h = 1e-6;
  for (const Vec3& p : {Vec3(0, 0, 2), Vec3(0.7, -0.4, 1.3), Vec3(-2, 1, 9)}) {
    Mat26 numeric;
    for (int k = 0; k < 6; ++k) {
      const Vec6 step = h * Vec6::Unit(k);
      numeric.col(k) =
          (camera.project(SE3::exp(step) * p) - camera.project(SE3::exp(-step) * p)) / (2 * h);
    }
    EXPECT_LT((pixelTwistJacobian(camera, p) - numeric).norm(), 1e-5 * numeric.norm());
  }
}

TEST(SparseAlignment, RecoversAKnownMotion) {
  const test::PlaneScene s = scene();
  const auto r = alignSparse(*s.pyramid(SE3(), 4), *s.pyramid(kMotion, 4), s.camera(), patchesOf(s),
                             SE3(), fine());
  expectMotion(r, kMotion, 0.03, 0.001);
  EXPECT_NEAR(r.gain, 1, 0.01);
  EXPECT_NEAR(r.offset, 0, 1);
  EXPECT_LT(r.rmse, 2);
}

TEST(SparseAlignment, CoarseLevelsAloneComeClose) {
  const test::PlaneScene s = scene();
  SparseAlignmentParameters p;
  p.max_level = 3;
  const auto r =
      alignSparse(*s.pyramid(SE3(), 4), *s.pyramid(kMotion, 4), s.camera(), patchesOf(s), SE3(), p);
  expectMotion(r, kMotion, 0.2, 0.01);
}

TEST(SparseAlignment, GainOffsetAndOutliersAreBorne) {
  const test::PlaneScene s = scene();
  auto patches = patchesOf(s);
  // Every fifth patch moves on its own: its content in the current image is another texture.
  const test::PlaneScene other(s.camera(), Vec3::UnitZ(), 2, 0.09, 77);
  const test::Light dim{0.6, 20}, bright{0.6 * 1.3, 20 * 1.3 + 15};
  cv::Mat cur = s.render(kMotion, bright);
  const cv::Mat wrong = other.render(SE3(), bright);
  for (std::size_t i = 0; i < patches.size(); i += 5) {
    const Vec2 px = s.camera().project(kMotion * patches[i].p_ref);
    const cv::Rect at =
        cv::Rect(int(px.x()) - 10, int(px.y()) - 10, 21, 21) & cv::Rect(0, 0, 320, 240);
    wrong(at).copyTo(cur(at));
  }
  const auto r = alignSparse(*s.pyramid(SE3(), 4, dim), *buildPyramid(cur, 4), s.camera(), patches,
                             SE3(), fine());
  expectMotion(r, kMotion, 0.1, 0.004);
  EXPECT_NEAR(r.gain, 1.3, 0.04);
  EXPECT_NEAR(r.offset, 15, 4);
}

TEST(SparseAlignment, StandingStillGivesTheIdentity) {
  const test::PlaneScene s = scene();
  const PyramidPtr pyramid = s.pyramid(SE3(), 4);
  const auto r = alignSparse(*pyramid, *pyramid, s.camera(), patchesOf(s), SE3(), fine());
  expectMotion(r, SE3(), 1e-4, 1e-5);
  EXPECT_LT(r.rmse, 1e-3);
}

TEST(SparseAlignment, AFixedGainStaysOne) {
  const test::PlaneScene s = scene();
  SparseAlignmentParameters p = fine();
  p.estimate_gain = false;
  const auto r =
      alignSparse(*s.pyramid(SE3(), 4), *s.pyramid(kMotion, 4), s.camera(), patchesOf(s), SE3(), p);
  expectMotion(r, kMotion, 0.03, 0.001);
  EXPECT_EQ(r.gain, 1);
  EXPECT_EQ(r.offset, 0);
}

TEST(SparseAlignment, TooFewPatchesAreNotEnough) {
  const test::PlaneScene s = scene();
  const PyramidPtr a = s.pyramid(SE3(), 4), b = s.pyramid(kMotion, 4);
  auto patches = patchesOf(s);
  EXPECT_FALSE(alignSparse(*a, *b, s.camera(), {}, SE3(), fine()).ok);
  patches.resize(7);
  const auto few = alignSparse(*a, *b, s.camera(), patches, kMotion, fine());
  EXPECT_FALSE(few.ok);
  EXPECT_EQ(few.T_cur_ref.matrix(), kMotion.matrix());  // the prediction is handed back
  auto behind = patchesOf(s);
  for (AlignmentPatch& p : behind) p.p_ref *= -1;
  EXPECT_FALSE(alignSparse(*a, *b, s.camera(), behind, SE3(), fine()).ok);
}

TEST(SparseAlignment, BlankImagesYieldNoNonsense) {
  const test::PlaneScene s = scene();
  const PyramidPtr image = s.pyramid(SE3(), 4);
  for (const int grey : {0, 255}) {
    const PyramidPtr blank = buildPyramid(cv::Mat(240, 320, CV_8UC1, cv::Scalar(grey)), 4);
    for (const auto& [a, b] :
         {std::pair(image, blank), std::pair(blank, image), std::pair(blank, blank)}) {
      const auto r = alignSparse(*a, *b, s.camera(), patchesOf(s), SE3(), fine());
      EXPECT_TRUE(r.T_cur_ref.finite());
      EXPECT_TRUE(std::isfinite(r.gain) && std::isfinite(r.offset) && std::isfinite(r.rmse));
    }
  }
}

TEST(SparseAlignment, UsesNoMorePatchesThanAllowed) {
  const test::PlaneScene s = scene();
  SparseAlignmentParameters p = fine();
  p.max_patches = 40;
  const auto r = alignSparse(*s.pyramid(SE3(), 4), *s.pyramid(kMotion, 4), s.camera(),
                             patchesOf(s, 12), SE3(), p);
  expectMotion(r, kMotion, 0.1, 0.004);
  EXPECT_LE(r.patches, 40);
}

TEST(PhotometricError, IsLowestAtTheTrueMotion) {
  const test::PlaneScene s = scene();
  const auto patches = patchesOf(s);
  const PyramidPtr a = s.pyramid(SE3(), 4), b = s.pyramid(kMotion, 4, {1.1, 5});
  const auto error = [&](const SE3& T) {
    return photometricError(*a, *b, s.camera(), patches, T, 2);
  };
  EXPECT_LT(error(kMotion), 0.2 * error(SE3()));
  EXPECT_LT(error(kMotion), error(kMotion * kMotion));
  const SE3 away(so3Exp(Vec3(0, 1.2, 0)), Vec3::Zero());
  EXPECT_EQ(error(away), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace svoscope
