// SPDX-License-Identifier: MIT
#include "engine/tracking/map_keeper.h"

#include <gtest/gtest.h>

#include "tests/support/tracked_wall.h"

namespace svoscope {
namespace {

using test::TrackedWall;

/// A start on the wall: reference at the origin, the second view a little to the side, in units of
/// the wall's depth.
struct Begun {
  TrackedWall wall{0};
  MapKeeper keeper{wall.map.camera};
  TrackerParameters parameters;
  Frame frame;

  Begun() {
    const SE3 T_metric = TrackedWall::shifted(-0.2);
    frame = wall.frame(5, T_metric);
    InitializerOutput start;
    start.initialized = true;
    start.reference_index = 0;
    start.reference_pyramid = wall.scene.pyramid(SE3(), TrackedWall::kLevels);
    start.T_cur_ref = TrackedWall::shifted(-0.1);
    for (const Vec2& px : test::gridPixels(wall.map.camera, 24, 40)) {
      InitializerPoint p;
      p.px_ref = px;
      p.p_ref = 0.5 * wall.scene.point(SE3(), px);
      p.px_cur = wall.map.camera.project(start.T_cur_ref * p.p_ref);
      start.points.push_back(p);
    }
    keeper.beginMap(start, parameters, frame);
  }
  int addKeyframe() { return keeper.insertKeyframe(parameters, frame); }
  MappingJob job() {
    keeper.requestMapping(frame, Frame{}, parameters.mapping);
    return keeper.takeJob().value();
  }
};

TEST(MapKeeper, TheStartBecomesAKeyframeAndTheFeaturesOfTheFrame) {
  Begun b;
  const Map& map = b.keeper.map();
  ASSERT_EQ(map.keyframes.size(), 1u);
  EXPECT_EQ(map.landmarks.size(), b.frame.features.size());
  EXPECT_GT(b.frame.features.size(), 40u);
  EXPECT_NEAR(map.keyframes.at(0).median_depth, 1, 1e-9);
  for (const TrackedFeature& f : b.frame.features) EXPECT_LT(f.error_px, 1e-9);
}

TEST(MapKeeper, AKeyframeObservesTheInliersOfItsFrame) {
  Begun b;
  b.frame.features.front().status = FeatureStatus::outlier;
  const std::int64_t outlier = b.frame.features.front().id;
  const int id = b.addKeyframe();
  EXPECT_EQ(id, 1);
  for (const auto& [landmark_id, landmark] : b.keeper.map().landmarks)
    EXPECT_EQ(landmark.observations.size(), landmark_id == outlier ? 1u : 2u);
  EXPECT_EQ(b.keeper.map().keyframes.at(1).landmarks.size(), b.frame.features.size() - 1);
}

TEST(MapKeeper, AJobIsTakenOnceAndItsAnswerAddsSeedsToTheKeyframe) {
  Begun b;
  b.addKeyframe();
  const MappingJob job = b.job();
  EXPECT_FALSE(b.keeper.takeJob().has_value());
  EXPECT_TRUE(job.new_seeds.wanted);
  EXPECT_EQ(job.new_seeds.keyframe_id, 1);
  ASSERT_EQ(job.older_views.size(), 1u) << "the reference of the start";
  MappingResult result = runMappingJob(job, b.parameters.mapping);
  ASSERT_FALSE(result.new_seeds.empty());
  const std::size_t found = result.new_seeds.size();
  std::size_t measured = 0;
  for (const NewSeed& seed : result.new_seeds) measured += seed.measurements.size();
  const auto answer = b.keeper.apply(std::move(result), b.parameters, b.frame);
  EXPECT_EQ(answer.tally.updates, static_cast<int>(measured));
  const auto& seeds = b.keeper.map().keyframes.at(1).seeds;
  ASSERT_EQ(seeds.size(), found);
  for (std::size_t i = 1; i < seeds.size(); ++i) EXPECT_EQ(seeds[i].id, seeds[i - 1].id + 1);
  // An ordinary frame asks for the seeds it has not measured itself, and for no new ones.
  b.frame.index = 6;
  const MappingJob next = b.job();
  EXPECT_FALSE(next.new_seeds.wanted);
}

TEST(MapKeeper, AnswersComeInTheScaleOfTheirJob) {
  Begun b;
  b.addKeyframe();
  Map map = b.keeper.map();
  map.keyframes.at(1).scale = 2;
  MappingResult result;
  result.keyframe_id = 1;
  result.median_depth = 3;
  result.scales = {{0, 1}, {1, 1}};
  SeedMeasurement m;
  m.x = 0.8;
  m.tau = 0.1;
  m.keyframe_id = 0;
  result.measurements.push_back(m);
  m.keyframe_id = 1;
  result.measurements.push_back(m);
  bringToScale(map, result);
  EXPECT_EQ(result.measurements[0].x, 0.8);
  EXPECT_EQ(result.measurements[1].x, 0.4);
  EXPECT_EQ(result.measurements[1].tau, 0.05);
  EXPECT_EQ(result.median_depth, 6);
}

TEST(MapKeeper, OneKeyframeTooManyMakesTheFarthestGo) {
  Begun b;
  b.parameters.keyframe.max_keyframes = 1;
  const int id = b.addKeyframe();
  ASSERT_EQ(b.keeper.map().keyframes.size(), 1u);
  EXPECT_TRUE(b.keeper.map().keyframes.count(id));
  for (const TrackedFeature& f : b.frame.features)
    EXPECT_EQ(f.status, FeatureStatus::outlier) << "its landmarks went with the reference";
}

TEST(MapKeeper, IdentifiersReturnOnlyWhenNothingSpeaksOfTheOldMap) {
  Begun b;
  b.addKeyframe();
  const std::int64_t next_id = b.keeper.map().next_id;
  b.keeper.requestMapping(b.frame, Frame{}, b.parameters.mapping);
  b.keeper.reset(true);
  EXPECT_TRUE(b.keeper.map().keyframes.empty());
  EXPECT_EQ(b.keeper.map().next_id, next_id);
  EXPECT_EQ(b.keeper.map().next_keyframe_id, 2);
  EXPECT_EQ(b.keeper.map().camera.width, b.wall.map.camera.width);
  EXPECT_FALSE(b.keeper.takeJob().has_value());
  b.keeper.reset(false);
  EXPECT_EQ(b.keeper.map().next_id, 0);
  EXPECT_EQ(b.keeper.map().next_keyframe_id, 0);
}

TEST(MapKeeper, SeedsOfKeyframesOutOfSightEnd) {
  Begun b;
  b.addKeyframe();
  b.keeper.apply(runMappingJob(b.job(), b.parameters.mapping), b.parameters, b.frame);
  const int seeds = b.keeper.map().seedCount();
  ASSERT_GT(seeds, 0);
  b.keeper.setLocalKeyframes({1});
  b.keeper.beginFrame(60);
  b.keeper.setLocalKeyframes({});
  b.keeper.beginFrame(120);
  EXPECT_EQ(b.keeper.map().seedCount(), seeds);
  b.keeper.beginFrame(121);
  EXPECT_EQ(b.keeper.map().seedCount(), 0);
  ASSERT_EQ(b.keeper.map().orphans.size(), static_cast<std::size_t>(seeds));
  EXPECT_EQ(b.keeper.map().orphans.front().seed.ending, SeedEnding::out_of_sight);
  b.keeper.beginFrame(122);
  EXPECT_TRUE(b.keeper.map().orphans.empty());
}

TEST(MapAdjustment, EverythingFollowsTheKeyframeThatMoved) {
  TrackedWall wall;
  Frame frame = wall.registered(1, wall.map.keyframes.at(0));
  const Vec3 before = frame.features.front().p_world;
  AdjustmentResult adjustment;
  EXPECT_FALSE(adoptAdjustment(adjustment, {}, 1, wall.map, frame).has_value());
  adjustment.ok = true;
  EXPECT_FALSE(adoptAdjustment(adjustment, {}, 1, wall.map, frame).has_value());
  adjustment.keyframes.resize(1);
  adjustment.keyframes[0].id = 0;
  adjustment.keyframes[0].T_cam_world = TrackedWall::shifted(0.5);
  const auto change = adoptAdjustment(adjustment, {}, 1, wall.map, frame);
  ASSERT_TRUE(change.has_value());
  EXPECT_NEAR(wall.map.keyframes.at(0).T_cam_world.translation().x(), 0.5, 1e-12);
  EXPECT_NEAR(frame.T_cam_world.translation().x(), 0.5, 1e-12);
  EXPECT_NEAR((frame.features.front().p_world - before + Vec3(0.5, 0, 0)).norm(), 0, 1e-12);
}

}  // namespace
}  // namespace svoscope
