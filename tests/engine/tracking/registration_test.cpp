// SPDX-License-Identifier: MIT
#include "engine/tracking/registration.h"

#include <gtest/gtest.h>

#include "tests/support/tracked_wall.h"

namespace svoscope {
namespace {

double distance(const SE3& a, const SE3& b) {
  return (a.inverse().translation() - b.inverse().translation()).norm();
}

TEST(Registration, FindsThePoseAndChangesNothing) {
  const test::TrackedWall wall;
  const Frame last = wall.registered(0, wall.map.keyframes.at(0));
  const SE3 T = SE3(so3Exp(Vec3(0.004, -0.006, 0.003)), Vec3(0.03, -0.01, 0.02));
  const Frame frame = wall.frame(1, T);
  const Registration r = registerFrame(frame, last, wall.map, {SE3()}, {});
  ASSERT_TRUE(r.good()) << r.failure;
  EXPECT_LT(distance(r.T_cam_world, T), 0.003);
  EXPECT_LT(test::angleDeg(r.T_cam_world, T), 0.1);
  EXPECT_GE(r.funnel.candidates, r.funnel.projected);
  EXPECT_GE(r.funnel.tried, r.funnel.matched);
  EXPECT_EQ(r.funnel.matched, static_cast<int>(r.features.size()));
  EXPECT_EQ(r.funnel.required, QualityParameters().min_inliers);
  EXPECT_GT(r.funnel.aligned_sparse, 0);
  EXPECT_EQ(r.local_keyframes, std::vector<int>{0});
  int inliers = 0;
  for (const TrackedFeature& f : r.features) inliers += f.status == FeatureStatus::inlier;
  EXPECT_EQ(inliers, r.funnel.inliers);
  // Pure: also the pose of the frame and the counts of the landmarks are left to the caller.
  EXPECT_TRUE(frame.features.empty());
  EXPECT_EQ(frame.T_cam_world.matrix(), SE3().matrix());
  for (const auto& [id, landmark] : wall.map.landmarks)
    EXPECT_EQ(landmark.succeeded + landmark.failed, 0);
  const Registration again = registerFrame(frame, last, wall.map, {SE3()}, {});
  EXPECT_EQ(again.T_cam_world.matrix(), r.T_cam_world.matrix());
}

TEST(Registration, ARefusedOneSaysWhyAndKeepsItsNumbers) {
  const test::TrackedWall wall;
  const Frame last = wall.registered(0, wall.map.keyframes.at(0));
  Frame black;
  black.pyramid =
      buildPyramid(cv::Mat(240, 320, CV_8UC1, cv::Scalar(0)), test::TrackedWall::kLevels);
  const Registration r = registerFrame(black, last, wall.map, {SE3()}, {});
  EXPECT_TRUE(r.judged);
  EXPECT_FALSE(r.good());
  EXPECT_NE(r.failure.find("20 required"), std::string::npos) << r.failure;
  EXPECT_GT(r.funnel.tried, 0);
  EXPECT_FALSE(r.failed_features.empty());
}

TEST(Registration, TheWholeImageReachesFartherThanThePrediction) {
  const test::TrackedWall wall;
  const Frame last = wall.registered(0, wall.map.keyframes.at(0));
  const SE3 T = SE3(so3Exp(Vec3(0, 0.09, 0)), Vec3::Zero());  // 27 px
  const Frame frame = wall.frame(1, T);
  Prediction wide;
  wide.wide = true;
  const Registration r = registerFrame(frame, last, wall.map, wide, {});
  ASSERT_TRUE(r.good()) << r.failure;
  EXPECT_LT(test::angleDeg(r.T_cam_world, T), 0.1);
}

TEST(Registration, ARelocalizationMustFitAsWellAsUsual) {
  const test::TrackedWall wall;
  const SE3 T = test::TrackedWall::shifted(0.02);
  const Frame frame = wall.frame(1, T);
  TrackerParameters p;
  const Registration found = relocalizeFrame(frame, wall.map, SE3(), 0, p);
  ASSERT_TRUE(found.good()) << found.failure;
  EXPECT_LT(distance(found.T_cam_world, T), 0.003);
  EXPECT_EQ(found.funnel.required, p.quality.relocalized_inliers);
  EXPECT_TRUE(relocalizeFrame(frame, wall.map, SE3(), found.noise_px, p).good());
  p.quality.relocalized_noise = 1e-3;
  const Registration noisy = relocalizeFrame(frame, wall.map, SE3(), found.noise_px, p);
  EXPECT_FALSE(noisy.good());
  EXPECT_FALSE(noisy.judged) << "refused before it was held against the thresholds";
  EXPECT_NE(noisy.failure.find("px allowed"), std::string::npos) << noisy.failure;
}

TEST(Registration, ARelocalizationMustFitAShareOfWhatWasTried) {
  const test::TrackedWall wall;
  TrackerParameters p;
  p.quality.relocalized_fraction = 1.5;
  const Registration r = relocalizeFrame(wall.frame(1, SE3()), wall.map, SE3(), 0, p);
  EXPECT_TRUE(r.judged);
  EXPECT_FALSE(r.good());
  EXPECT_EQ(r.funnel.required, static_cast<int>(1.5 * r.funnel.tried));
}

TEST(Registration, PatchesAreThoseOfTheInliers) {
  const test::TrackedWall wall;
  Frame last = wall.registered(0, wall.map.keyframes.at(0));
  const std::size_t all = last.features.size();
  last.features.front().status = FeatureStatus::outlier;
  const auto patches = alignmentPatches(last, wall.map.camera, {});
  ASSERT_EQ(patches.size(), all - 1);
  EXPECT_NEAR(patches.front().p_ref.z(), 2, 1e-9);
}

}  // namespace
}  // namespace svoscope
