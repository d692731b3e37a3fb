// SPDX-License-Identifier: MIT
#include "engine/tracking/relocalizer.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "tests/support/plane_scene.h"

namespace svoscope {
namespace {

constexpr int kLevels = 4;

/// Five keyframes along a wide wall, 1.2 m apart, each with landmarks.
struct Wall {
  Wall() : scene(test::smallCamera(), Vec3::UnitZ(), 2, 0.09) {
    map.camera = scene.camera();
    for (int i = 0; i < 5; ++i) {
      Keyframe& k = map.keyframes[i];
      k.id = i;
      k.T_cam_world = SE3(Eigen::Quaterniond::Identity(), Vec3(-1.2 * i, 0, 0));
      k.pyramid = scene.pyramid(k.T_cam_world, kLevels);
      k.thumbnail = makeThumbnail(*k.pyramid);
      for (const Vec2& px : test::gridPixels(map.camera, 24, 30)) {
        Landmark& landmark = map.addLandmark(scene.point(k.T_cam_world, px), FeatureType::corner);
        FeatureAnchor anchor;
        anchor.px = px;
        anchor.f = map.camera.bearing(px);
        map.addObservation(landmark, k, anchor);
      }
    }
  }
  std::vector<RelocalizationCandidate> candidates(const SE3& T, test::Light light = {}) const {
    SparseAlignmentParameters alignment;
    alignment.min_level = 1;
    return relocalizationCandidates(map, *scene.pyramid(T, kLevels, light), alignment, {});
  }
  test::PlaneScene scene;
  Map map;
};

TEST(Thumbnail, HasZeroMeanAndUnitNorm) {
  const test::PlaneScene scene(test::smallCamera(), Vec3::UnitZ(), 2, 0.09);
  const cv::Mat t = makeThumbnail(*scene.pyramid(SE3(), kLevels));
  EXPECT_EQ(t.type(), CV_32F);
  EXPECT_EQ(t.size(), cv::Size(40, 30));
  EXPECT_NEAR(cv::norm(t), 1, 1e-5);
  EXPECT_NEAR(cv::mean(t)[0], 0, 1e-6);
}

TEST(Thumbnail, BrightnessAndContrastDoNotMatter) {
  const test::PlaneScene scene(test::smallCamera(), Vec3::UnitZ(), 2, 0.09);
  const cv::Mat a = makeThumbnail(*scene.pyramid(SE3(), kLevels));
  const cv::Mat b = makeThumbnail(*scene.pyramid(SE3(), kLevels, {0.5, 70}));
  EXPECT_GT(a.dot(b), 0.99);
}

TEST(Thumbnail, ABlankImageIsAllZero) {
  const cv::Mat t =
      makeThumbnail(*buildPyramid(cv::Mat(240, 320, CV_8UC1, cv::Scalar(255)), kLevels));
  EXPECT_EQ(cv::countNonZero(t != t), 0);  // no NaN
  EXPECT_NEAR(cv::norm(t), 0, 1e-6);
}

TEST(Relocalizer, FindsTheKeyframeAndThePose) {
  const Wall wall;
  const Keyframe& third = wall.map.keyframes.at(2);
  const SE3 T = SE3(so3Exp(Vec3(0.01, 0.02, -0.01)), Vec3(0.03, -0.02, 0.05)) * third.T_cam_world;
  const auto found = wall.candidates(T, {0.8, 15});
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.front().keyframe_id, 2);
  EXPECT_GT(found.front().similarity, 0.5);
  EXPECT_LT((found.front().T_cam_world.translation() - T.translation()).norm(), 0.02);
  EXPECT_LT(test::angleDeg(found.front().T_cam_world, T), 0.5);
}

TEST(Relocalizer, TurnedViewsStartFromTheShiftOfTheThumbnails) {
  const Wall wall;
  for (const Vec3& omega :
       {Vec3(0, 0.07, 0), Vec3(0, -0.07, 0), Vec3(0.06, 0, 0), Vec3(-0.05, 0.05, 0)}) {
    const SE3 T =
        SE3(so3Exp(omega), Vec3::Zero()) * wall.map.keyframes.at(1).T_cam_world;  // 20 px and more
    const auto found = wall.candidates(T);
    ASSERT_FALSE(found.empty()) << omega.transpose();
    EXPECT_EQ(found.front().keyframe_id, 1);
    EXPECT_LT(test::angleDeg(found.front().T_cam_world, T), 0.5) << omega.transpose();
  }
}

TEST(Relocalizer, BlackFramesAndEmptyMapsGiveNothing) {
  const Wall wall;
  const PyramidPtr black = buildPyramid(cv::Mat(240, 320, CV_8UC1, cv::Scalar(0)), kLevels);
  EXPECT_TRUE(relocalizationCandidates(wall.map, *black, {}, {}).empty());
  EXPECT_TRUE(relocalizationCandidates(Map{}, *wall.scene.pyramid(SE3(), kLevels), {}, {}).empty());
}

TEST(Relocalizer, PatchesComeFromLandmarksAndConvergedSeedsOfTheKeyframe) {
  Wall wall;
  Keyframe& k = wall.map.keyframes.at(0);
  const std::size_t landmarks = k.landmarks.size();
  k.seeds.resize(2);
  k.seeds[0].status = SeedStatus::converged;
  k.seeds[0].anchor.f = wall.map.camera.bearing({100, 100});
  k.seeds[0].belief.mu = 0.25;
  const auto patches = keyframePatches(wall.map, k);
  ASSERT_EQ(patches.size(), landmarks + 1);
  EXPECT_NEAR(patches.back().p_ref.norm(), 4, 1e-9);
  EXPECT_NEAR(patches.front().p_ref.z(), 2, 1e-9);
}

}  // namespace
}  // namespace svoscope
