// SPDX-License-Identifier: MIT
#include "engine/mapping/map.h"

#include <gtest/gtest.h>

#include <random>

#include "engine/mapping/landmark_refinement.h"
#include "tests/support/plane_scene.h"

namespace svoscope {
namespace {

/// Keyframes along the x axis, looking along z.
Map threeKeyframes() {
  Map map;
  map.camera = test::smallCamera();
  for (int i = 0; i < 3; ++i) {
    Keyframe& k = map.keyframes[map.next_keyframe_id];
    k.id = map.next_keyframe_id++;
    k.T_cam_world = SE3(so3Exp(Vec3(0, 0.02 * i, 0)), Vec3(-0.2 * i, 0.01 * i, 0));
  }
  return map;
}

FeatureAnchor anchorOf(const Map& map, int keyframe, const Vec3& p_world) {
  FeatureAnchor anchor;
  anchor.px = map.camera.project(map.keyframes.at(keyframe).T_cam_world * p_world);
  anchor.f = map.camera.bearing(anchor.px);
  return anchor;
}

Landmark& observed(Map& map, const Vec3& p_world, const std::vector<int>& keyframes) {
  Landmark& landmark = map.addLandmark(p_world, FeatureType::corner);
  for (const int id : keyframes)
    map.addObservation(landmark, map.keyframes.at(id), anchorOf(map, id, p_world));
  return landmark;
}

void expectConsistent(const Map& map) {
  for (const auto& [id, keyframe] : map.keyframes) {
    for (const std::int64_t seen : keyframe.landmarks)
      EXPECT_NE(map.find(seen), nullptr) << "keyframe " << id;
  }
  for (const auto& [id, landmark] : map.landmarks) {
    for (const LandmarkObservation& o : landmark.observations) {
      ASSERT_TRUE(map.keyframes.count(o.keyframe_id)) << "landmark " << id;
      const auto& seen = map.keyframes.at(o.keyframe_id).landmarks;
      EXPECT_EQ(std::count(seen.begin(), seen.end(), id), 1);
    }
  }
}

TEST(Map, RemovingAKeyframeLeavesNothingDangling) {
  Map map = threeKeyframes();
  const auto everywhere = observed(map, {0, 0, 2}, {0, 1, 2}).id;
  const auto twice = observed(map, {0.1, 0, 2}, {0, 1}).id;
  const auto without = observed(map, {0.2, 0, 2}, {1, 2}).id;
  map.keyframes.at(0).seeds.resize(3);
  EXPECT_EQ(map.seedCount(), 3);
  map.removeKeyframe(0);
  expectConsistent(map);
  EXPECT_EQ(map.keyframes.size(), 2u);
  EXPECT_EQ(map.find(everywhere)->observations.size(), 2u);
  EXPECT_EQ(map.find(twice), nullptr);  // one view is not enough
  EXPECT_EQ(map.find(without)->observations.size(), 2u);
  EXPECT_EQ(map.seedCount(), 0);
  map.removeKeyframe(0);
  map.removeKeyframe(77);
  EXPECT_EQ(map.keyframes.size(), 2u);
}

TEST(Map, RemovingALandmarkForgetsItInItsKeyframes) {
  Map map = threeKeyframes();
  const auto id = observed(map, {0, 0, 2}, {0, 1, 2}).id;
  observed(map, {0.1, 0, 2}, {0, 2});
  map.removeLandmark(id);
  map.removeLandmark(12345);
  expectConsistent(map);
  EXPECT_EQ(map.landmarks.size(), 1u);
  EXPECT_EQ(map.keyframes.at(0).landmarks.size(), 1u);
}

TEST(Map, SeedsOfARemovedKeyframeAreLeftWithTheReason) {
  Map map = threeKeyframes();
  Keyframe& keyframe = map.keyframes.at(1);
  keyframe.seeds.resize(2);
  keyframe.segment_seeds.resize(3);
  keyframe.segment_seeds[0].status = SeedStatus::promoted;
  keyframe.segment_seeds[0].ending = SeedEnding::promoted;
  map.removeKeyframe(1);
  ASSERT_EQ(map.orphans.size(), 2u);
  EXPECT_EQ(map.orphans[1].seed.ending, SeedEnding::keyframe_removed);
  ASSERT_EQ(map.segment_orphans.size(), 3u);
  EXPECT_EQ(map.segment_orphans[0].seed.ending, SeedEnding::promoted) << "it had ended before";
  EXPECT_EQ(map.segment_orphans[2].seed.ending, SeedEnding::keyframe_removed);
  EXPECT_EQ(map.segment_orphans[2].seed.status, SeedStatus::rejected);
}

TEST(Map, EndedSeedsAreNotCounted) {
  Map map = threeKeyframes();
  auto& seeds = map.keyframes.at(1).seeds;
  seeds.resize(4);
  seeds[0].status = SeedStatus::converged;
  seeds[1].status = SeedStatus::rejected;
  seeds[2].status = SeedStatus::promoted;
  EXPECT_EQ(map.seedCount(), 2);
}

TEST(ClosestView, PicksTheSmallestAngleWithinTheLimit) {
  Map map = threeKeyframes();
  const Landmark& landmark = observed(map, {0, 0, 1}, {0, 1, 2});
  const auto view = [&](const Vec3& c, double min_cosine) {
    const LandmarkObservation* o = closestView(map, landmark, c, min_cosine);
    return o ? o->keyframe_id : -1;
  };
  const auto centre = [&](int id) {
    return map.keyframes.at(id).T_cam_world.inverse().translation();
  };
  for (int id = 0; id < 3; ++id) EXPECT_EQ(view(centre(id) + Vec3(0.01, 0, 0), 0.5), id);
  EXPECT_EQ(view(Vec3(0, 0, 2), 0.5), -1);    // from behind
  EXPECT_EQ(view(Vec3(3, 0, 0.5), 0.9), -1);  // from the side
}

TEST(LandmarkRefinement, ConvergesToTheTruth) {
  std::mt19937 rng(4);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int i = 0; i < 30; ++i) {
    Map map = threeKeyframes();
    const Vec3 truth(0.4 * u(rng), 0.3 * u(rng), 2 + 0.5 * u(rng));
    Landmark& landmark = observed(map, truth, {0, 1, 2});
    landmark.p_world += Vec3(0.02 * u(rng), 0.02 * u(rng), 0.3 * u(rng));
    EXPECT_TRUE(refineLandmark(landmark, map, 10));
    EXPECT_LT((landmark.p_world - truth).norm(), 1e-5);
    EXPECT_FALSE(refineLandmark(landmark, map, 0));
  }
}

TEST(LandmarkRefinement, CoarseViewsWeighLess) {
  Map map = threeKeyframes();
  const Vec3 truth(0, 0, 2);
  Landmark& landmark = observed(map, truth, {0, 1, 2});
  landmark.observations[2].anchor.f =
      map.camera.bearing(landmark.observations[2].anchor.px + Vec2(0, 4));
  Landmark coarse = landmark;
  coarse.observations[2].anchor.level = 3;
  refineLandmark(landmark, map, 10);
  refineLandmark(coarse, map, 10);
  EXPECT_LT((coarse.p_world - truth).norm(), 0.2 * (landmark.p_world - truth).norm());
}

double errorOf(const Map& map, const Landmark& landmark) {
  double sum = 0;
  for (const LandmarkObservation& o : landmark.observations) {
    const Vec3 p = map.keyframes.at(o.keyframe_id).T_cam_world * landmark.p_world;
    sum += (o.anchor.f.hnormalized() - p.hnormalized()).squaredNorm();
  }
  return sum;
}

TEST(LandmarkRefinement, NeverRaisesTheError) {
  std::mt19937 rng(9);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int i = 0; i < 200; ++i) {
    Map map = threeKeyframes();
    Landmark& landmark = observed(map, {0.3 * u(rng), 0.3 * u(rng), 1.5}, {0, 1, 2});
    for (auto& o : landmark.observations)  // wild outliers: Gauss-Newton may overshoot
      o.anchor.f = map.camera.bearing(o.anchor.px + 60 * Vec2(u(rng), u(rng)));
    const double before = errorOf(map, landmark);
    const Vec3 start = landmark.p_world;
    const bool changed = refineLandmark(landmark, map, 5);
    EXPECT_LE(errorOf(map, landmark), before);
    EXPECT_EQ(changed, landmark.p_world != start);
    EXPECT_TRUE(landmark.p_world.allFinite());
  }
}

TEST(LandmarkRefinement, LeavesEdgeletsSingleViewsAndPointsBehindAlone) {
  Map map = threeKeyframes();
  Landmark& edgelet = observed(map, {0, 0, 2}, {0, 1, 2});
  edgelet.type = FeatureType::edgelet;
  edgelet.p_world.z() = 2.3;
  EXPECT_FALSE(refineLandmark(edgelet, map, 5));
  EXPECT_EQ(edgelet.p_world.z(), 2.3);
  Landmark& single = observed(map, {0, 0, 2}, {1});
  single.p_world.z() = 2.3;
  EXPECT_FALSE(refineLandmark(single, map, 5));
  Landmark& behind = observed(map, {0, 0, 2}, {0, 1});
  behind.p_world.z() = -1;
  EXPECT_FALSE(refineLandmark(behind, map, 5));
  EXPECT_EQ(behind.p_world.z(), -1);
}

}  // namespace
}  // namespace svoscope
