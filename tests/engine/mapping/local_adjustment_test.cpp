// SPDX-License-Identifier: MIT
#include "engine/mapping/local_adjustment.h"

#include <gtest/gtest.h>

#include <random>

#include "engine/geometry/segment.h"
#include "engine/mapping/segment_seed_update.h"

namespace svoscope {
namespace {

constexpr int kKeyframes = 4;
const Vec3 kEnds[2] = {{-0.6, 0.4, 2.0}, {0.5, -0.3, 2.7}};

/// Keyframes on an arc before points and one segment, all exact; what a test wants wrong it
/// disturbs.
struct LocalAdjustmentTest : testing::Test {
  Map map;
  std::vector<SE3> true_poses;
  std::map<std::int64_t, Vec3> true_points;
  std::int64_t segment_id = -1;
  std::mt19937 rng{7};
  LocalAdjustmentParameters p;
  SegmentParameters segments;

  LocalAdjustmentTest() {
    segments.enabled = true;
    map.camera = {640, 480, 500, 500, 319.5, 239.5};
    for (int i = 0; i < kKeyframes; ++i) {
      Keyframe& k = map.keyframes[i];
      k.id = i;
      k.T_cam_world = SE3(so3Exp({0.01 * i, -0.03 * i, 0.02 * i}), {-0.12 * i, 0.05 * i, 0.03 * i});
      true_poses.push_back(k.T_cam_world);
    }
    std::uniform_real_distribution<double> x(-0.9, 0.9), z(1.8, 3.5);
    for (int n = 0; n < 60; ++n) addPoint({x(rng), 0.8 * x(rng), z(rng)});
    addSegment();
  }
  void addPoint(const Vec3& p_world) {
    Landmark& landmark = map.addLandmark(p_world, FeatureType::corner);
    true_points[landmark.id] = p_world;
    for (auto& [id, keyframe] : map.keyframes) {
      FeatureAnchor anchor;
      anchor.px = map.camera.project(keyframe.T_cam_world * p_world);
      anchor.f = map.camera.bearing(anchor.px);
      map.addObservation(landmark, keyframe, anchor);
    }
  }
  void addSegment() {
    SegmentLandmark s;
    s.id = segment_id = map.next_id++;
    for (int e = 0; e < 2; ++e) s.p_world[e] = kEnds[e];
    for (auto& [id, keyframe] : map.keyframes) {
      Vec2 px[2];
      for (int e = 0; e < 2; ++e) px[e] = map.camera.project(keyframe.T_cam_world * kEnds[e]);
      s.views.push_back({id, makeSegmentAnchor(px[0], px[1], map.camera, 0)});
      keyframe.segments.push_back(s.id);
    }
    map.segments.emplace(s.id, s);
  }
  AdjustmentResult adjust() {
    p.max_iterations = 30;
    return adjustLocally(localProblem(map, kKeyframes - 1, p, segments), p);
  }
  /// Distance of a point from the true segment's line.
  static double offLine(const Vec3& p_world) {
    const Vec3 along = (kEnds[1] - kEnds[0]).normalized();
    return along.cross(p_world - kEnds[0]).norm();
  }
};

TEST_F(LocalAdjustmentTest, RestoresPosesPointsAndSegments) {
  std::normal_distribution<double> n(0, 1);
  const auto noise = [&](double s) { return Vec3(s * n(rng), s * n(rng), s * n(rng)); };
  for (int i = 1; i < kKeyframes; ++i) {
    SE3& T = map.keyframes[i].T_cam_world;
    T = SE3(so3Exp(noise(0.003)), noise(0.006)) * T;
  }
  for (auto& [id, landmark] : map.landmarks) landmark.p_world += noise(0.02);
  for (Vec3& end : map.segments.at(segment_id).p_world) end += noise(0.03);
  const AdjustmentResult result = adjust();
  ASSERT_TRUE(result.ok);
  EXPECT_LT(result.final_px, 0.05 * result.initial_px);
  // The scale is free: compare what is left after taking it out.
  const double scale = result.keyframes.back().T_cam_world.translation().norm() /
                       true_poses.back().translation().norm();
  EXPECT_NEAR(scale, 1, 0.1);
  for (const AdjustmentKeyframe& k : result.keyframes) {
    const SE3 T(k.T_cam_world.quaternion(), k.T_cam_world.translation() / scale);
    EXPECT_LT((T * true_poses[static_cast<std::size_t>(k.id)].inverse()).log().norm(), 1e-3)
        << k.id;
  }
  for (const AdjustmentPoint& x : result.points)
    EXPECT_LT((x.p_world / scale - true_points.at(x.id)).norm(), 5e-3);
  ASSERT_EQ(result.ends.size(), 2u);
  for (const AdjustmentEnd& end : result.ends) EXPECT_LT(offLine(end.p_world / scale), 5e-3);
  EXPECT_TRUE(result.outliers.empty());
  EXPECT_TRUE(result.segment_outliers.empty());
}

TEST_F(LocalAdjustmentTest, HoldsTheOldestKeyframeAndTheFixedOnes) {
  map.keyframes[2].T_cam_world =
      SE3(so3Exp({0.004, 0, 0}), {0.01, 0, 0}) * map.keyframes[2].T_cam_world;
  const AdjustmentResult result = adjust();
  ASSERT_TRUE(result.ok);
  int held = 0;
  for (const AdjustmentKeyframe& k : result.keyframes) {
    if (!k.fixed) continue;
    ++held;
    EXPECT_EQ(k.T_cam_world.matrix(), true_poses[static_cast<std::size_t>(k.id)].matrix());
  }
  EXPECT_EQ(held, 1);
}

TEST_F(LocalAdjustmentTest, NamesTheViewsThatDoNotFit) {
  const std::int64_t bad = map.landmarks.begin()->first;
  for (LandmarkObservation& o : map.find(bad)->observations) {
    if (o.keyframe_id == 2) o.anchor.px += Vec2(12, -9);
  }
  SegmentView& view = map.segments.at(segment_id).views[1];
  const Vec2 normal = lineThrough(view.anchor.px[0], view.anchor.px[1]).normal;
  for (Vec2& px : view.anchor.px) px += 15 * normal;
  const AdjustmentResult result = adjust();
  ASSERT_TRUE(result.ok);
  ASSERT_EQ(result.outliers.size(), 1u);
  EXPECT_EQ(result.outliers[0].landmark_id, bad);
  EXPECT_EQ(result.outliers[0].keyframe_id, 2);
  ASSERT_FALSE(result.segment_outliers.empty());
  for (const auto& o : result.segment_outliers) {
    EXPECT_EQ(o.landmark_id, segment_id);
    EXPECT_EQ(o.keyframe_id, view.keyframe_id);
  }
}

TEST_F(LocalAdjustmentTest, SeedDepthsWithACommonErrorDoNotMoveTheScale) {
  // All seeds believe in a map 20 % larger than the points and keyframes are: that is no evidence.
  SegmentLandmark& s = map.segments.at(segment_id);
  for (int e = 0; e < 2; ++e) {
    const Vec3 q = map.keyframes[0].T_cam_world * kEnds[e];
    s.prior[e] = 1 / (1.2 * s.views.front().anchor.f[e].dot(q));
    s.prior_sigma[e] = 1e-4;
  }
  const AdjustmentResult result = adjust();
  ASSERT_TRUE(result.ok);
  for (const AdjustmentKeyframe& k : result.keyframes)
    EXPECT_LT((k.T_cam_world * true_poses[static_cast<std::size_t>(k.id)].inverse()).log().norm(),
              2e-3)
        << k.id;
  for (const AdjustmentEnd& end : result.ends) EXPECT_LT(offLine(end.p_world), 1e-2);
}

TEST_F(LocalAdjustmentTest, ASegmentSeenTwiceStaysOutside) {
  auto& views = map.segments.at(segment_id).views;
  views.erase(views.begin() + 2, views.end());
  EXPECT_TRUE(localProblem(map, kKeyframes - 1, p, segments).ends.empty());
  p.segment_views = 2;
  EXPECT_EQ(localProblem(map, kKeyframes - 1, p, segments).ends.size(), 2u);
  segments.enabled = false;
  EXPECT_TRUE(localProblem(map, kKeyframes - 1, p, segments).ends.empty());
}

TEST_F(LocalAdjustmentTest, AnEndPointBehindACameraIsNotMeasuredThere) {
  SegmentLandmark& s = map.segments.at(segment_id);
  s.p_world[1] = map.keyframes[3].T_cam_world.inverse() * Vec3(0.2, 0.1, -0.5);
  const AdjustmentProblem problem = localProblem(map, kKeyframes - 1, p, segments);
  for (const AdjustmentLineView& v : problem.line_views) {
    const Vec3 q = problem.keyframes[static_cast<std::size_t>(v.keyframe)].T_cam_world *
                   problem.ends[static_cast<std::size_t>(v.end)].p_world;
    EXPECT_GT(q.z(), 0);
    EXPECT_TRUE(v.px.allFinite());
    EXPECT_NEAR(v.direction.norm(), 1, 1e-9);
  }
}

TEST_F(LocalAdjustmentTest, TheSameProblemGivesTheSameBytes) {
  map.keyframes[2].T_cam_world =
      SE3(so3Exp({0.004, 0, 0}), {0.01, 0, 0}) * map.keyframes[2].T_cam_world;
  const AdjustmentResult first = adjust();
  const std::vector<char> elsewhere(4097);  // moves what is allocated next
  const AdjustmentResult second = adjust();
  for (std::size_t i = 0; i < first.keyframes.size(); ++i)
    EXPECT_EQ(first.keyframes[i].T_cam_world.matrix(), second.keyframes[i].T_cam_world.matrix());
  for (std::size_t i = 0; i < first.points.size(); ++i)
    EXPECT_EQ(first.points[i].p_world, second.points[i].p_world);
}

TEST_F(LocalAdjustmentTest, TooFewPointsAreLeftAlone) {
  while (map.landmarks.size() > 9) map.removeLandmark(map.landmarks.begin()->first);
  EXPECT_FALSE(adjust().ok);
}

}  // namespace
}  // namespace svoscope
