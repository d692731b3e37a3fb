// SPDX-License-Identifier: MIT
// The whole front end on built-in sequences: start, tracking, loss, recovery.
#include "engine/tracking/tracker.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "engine/eval/estimate.h"
#include "engine/eval/evaluate.h"
#include "tests/support/memory_sequence.h"

namespace svoscope {
namespace {

constexpr const char* kRoom = "synthetic:room?size=320x240&frames=60";

struct TrackedRun {
  std::vector<FrameRecord> records;
  std::vector<Event> events;
  Trajectory truth, estimate;
  int first_pose = -1;

  int count(EventKind kind) const {
    return static_cast<int>(std::count_if(events.begin(), events.end(),
                                          [&](const Event& e) { return e.kind == kind; }));
  }
  int good() const { return static_cast<int>(estimate.size()); }
  double pathLength() const {
    double length = 0;
    for (std::size_t i = static_cast<std::size_t>(first_pose) + 1; i < truth.size(); ++i)
      length +=
          (truth[i].T_world_cam.translation() - truth[i - 1].T_world_cam.translation()).norm();
    return length;
  }
  /// RMSE over the path since the start, after the best similarity.
  double relativeError() const {
    const auto result = evaluate(truth, estimate);
    return result.ok() ? result.value().ate.rmse / pathLength() : 1e9;
  }
};

TrackedRun track(Tracker& tracker, Sequence& sequence) {
  TrackedRun run;
  run.truth = sequence.groundTruth();
  for (int i = 0; i < sequence.size(); ++i) {
    const SequenceImage image = sequence.read(i).value();
    tracker.process(i, image.timestamp, image.gray);
    if (const auto job = tracker.takeMappingJob())
      tracker.applyMapping(runMappingJob(*job, tracker.parameters().mapping));
    const FrameRecord& r = tracker.record();
    run.records.push_back(r);
    run.events.insert(run.events.end(), tracker.events().begin(), tracker.events().end());
    if (!r.pose_good) continue;
    if (run.first_pose < 0) run.first_pose = i;
    run.estimate.push_back({r.timestamp, r.T_world_cam});
  }
  return run;
}

TrackedRun trackText(const std::string& spec,
                     const test::ChangedSequence::Change& change = nullptr) {
  test::ChangedSequence sequence(test::openBuiltIn(spec), change);
  Tracker tracker(sequence.camera().pinhole, {});
  return track(tracker, sequence);
}

void expectTracked(const TrackedRun& run, int frames) {
  ASSERT_GE(run.first_pose, 0);
  EXPECT_LT(run.first_pose, 40);
  EXPECT_EQ(run.good(), frames - run.first_pose);
  EXPECT_EQ(run.count(EventKind::initialized), 1);
  EXPECT_EQ(run.count(EventKind::lost), 0);
  EXPECT_LE(run.relativeError(), 0.005);
}

TEST(Tracker, FollowsTheRoom) { expectTracked(trackText(kRoom), 60); }
TEST(Tracker, FollowsTheDesk) {
  expectTracked(trackText("synthetic:desk?size=320x240&frames=60"), 60);
}

TEST(Tracker, RecordsExplainEveryFrame) {
  const TrackedRun run = trackText(kRoom);
  for (const FrameRecord& r : run.records) {
    EXPECT_FALSE(r.reason.empty()) << r.index;
    if (!r.pose_good || r.is_keyframe) continue;
    const Funnel& f = r.funnel;
    EXPECT_FALSE(r.keyframe_reason.empty()) << r.index;
    EXPECT_GE(f.candidates, f.projected);
    EXPECT_GE(f.projected, f.tried);
    EXPECT_GE(f.tried, f.matched);
    EXPECT_GE(f.matched, f.inliers);
    EXPECT_GE(f.inliers, f.required);
    EXPECT_EQ(f.inlier_landmarks + f.inlier_seeds, f.inliers) << r.index;
    EXPECT_GT(r.median_depth, 0);
  }
}

TEST(Tracker, RecoversFromABlackoutWithTheSameScale) {
  const TrackedRun run = trackText("synthetic:room?size=320x240&frames=90&speed=0.6&blackout=60:5");
  ASSERT_GE(run.first_pose, 0);
  ASSERT_LT(run.first_pose, 55);
  for (int i = 60; i < 65; ++i) {
    EXPECT_FALSE(run.records[static_cast<std::size_t>(i)].pose_good) << i;
    EXPECT_EQ(run.records[static_cast<std::size_t>(i)].state, TrackingState::lost) << i;
  }
  EXPECT_EQ(run.count(EventKind::lost), 1);
  EXPECT_EQ(run.count(EventKind::relocalized), 1);
  EXPECT_EQ(run.count(EventKind::initialized), 1);
  EXPECT_TRUE(run.records[65].relocalized || run.records[66].relocalized);
  EXPECT_GE(run.good(), 90 - run.first_pose - 7);
  EXPECT_LE(run.relativeError(), 0.01);
}

TEST(Tracker, OneWhiteImageIsALossOfOneFrame) {
  const TrackedRun run = trackText(kRoom, [](int i, cv::Mat& gray) {
    if (i == 50) gray.setTo(255);
  });
  ASSERT_GE(run.first_pose, 0);
  ASSERT_LT(run.first_pose, 48);
  EXPECT_FALSE(run.records[50].pose_good);
  EXPECT_TRUE(run.records[51].pose_good || run.records[52].pose_good);
  EXPECT_TRUE(run.records.back().pose_good);
  EXPECT_LE(run.relativeError(), 0.01);
}

TEST(Tracker, AStandingCameraNeverStarts) {
  const TrackedRun run = trackText("synthetic:still?size=320x240&frames=60");
  EXPECT_EQ(run.good(), 0);
  EXPECT_EQ(run.records.back().state, TrackingState::initializing);
  EXPECT_FALSE(run.records.back().reason.empty());
}

TEST(Tracker, BlackImagesNeverStart) {
  const TrackedRun run = trackText("synthetic:room?size=320x240&frames=20&noise=0&blackout=0:20");
  EXPECT_EQ(run.good(), 0);
  EXPECT_TRUE(run.events.empty());
}

TEST(Tracker, ResetGivesTheSameRunAgain) {
  const auto sequence = test::openBuiltIn(kRoom);
  Tracker tracker(sequence->camera().pinhole, {});
  const TrackedRun first = track(tracker, *sequence);
  ASSERT_GT(first.good(), 10);
  tracker.reset();
  EXPECT_TRUE(tracker.map().keyframes.empty());
  EXPECT_TRUE(tracker.map().landmarks.empty());
  EXPECT_FALSE(tracker.takeMappingJob().has_value());
  const TrackedRun second = track(tracker, *sequence);
  ASSERT_EQ(first.good(), second.good());
  for (std::size_t i = 0; i < first.estimate.size(); ++i)
    EXPECT_EQ(first.estimate[i].T_world_cam.matrix(), second.estimate[i].T_world_cam.matrix());
}

/// The room, and from frame `cut` on the scene before a desk.
struct SceneCut {
  std::unique_ptr<Sequence> room, desk;
  int cut;
  explicit SceneCut(int at)
      : room(test::openBuiltIn("synthetic:room?size=320x240&frames=120")),
        desk(test::openBuiltIn("synthetic:desk?size=320x240&frames=160")),
        cut(at) {}
  SequenceImage image(int i) const {
    return i < cut ? room->read(i).value() : desk->read(i - cut).value();
  }
};

TEST(Tracker, AnOldMapsAnswersDoNotReachTheNewMap) {
  // Identifiers must not return: a mapping answer, or whatever is kept by keyframe, may still speak
  // of the old map.
  const SceneCut scene(30);
  TrackerParameters p;
  p.quality.fresh_lost_frames = p.quality.lost_frames = 2;
  Tracker tracker(scene.room->camera().pinhole, p);
  int starts = 0, newest = -1;
  std::int64_t newest_point = -1;
  for (int i = 0; i < 180; ++i) {
    tracker.process(i, i / 30.0, scene.image(i).gray);
    for (const Event& e : tracker.events()) starts += e.kind == EventKind::initialized;
    if (starts == 2) break;
    for (const auto& [id, keyframe] : tracker.map().keyframes) newest = std::max(newest, id);
    for (const auto& [id, landmark] : tracker.map().landmarks)
      newest_point = std::max(newest_point, id);
  }
  ASSERT_EQ(starts, 2);
  ASSERT_GE(newest, 1);
  for (const auto& [id, keyframe] : tracker.map().keyframes) EXPECT_GT(id, newest);
  for (const auto& [id, landmark] : tracker.map().landmarks) EXPECT_GT(id, newest_point);
}

TEST(Tracker, AnUnknownSceneIsALossAndGetsAMapOfItsOwn) {
  const SceneCut scene(60);
  TrackerParameters p;
  p.quality.lost_frames = 5;
  Tracker tracker(scene.room->camera().pinhole, p);
  std::vector<FrameRecord> records;
  std::vector<EventKind> told;
  for (int i = 0; i < 200; ++i) {
    const SequenceImage image = scene.image(i);
    tracker.process(i, i / 30.0, image.gray);
    if (const auto job = tracker.takeMappingJob())
      tracker.applyMapping(runMappingJob(*job, p.mapping));
    records.push_back(tracker.record());
    for (const Event& e : tracker.events()) {
      if (e.kind != EventKind::keyframe) told.push_back(e.kind);
    }
  }
  EXPECT_EQ(records[59].map_id, 0);
  ASSERT_TRUE(records[59].pose_good);
  for (int i = 60; i < 66; ++i) EXPECT_FALSE(records[static_cast<std::size_t>(i)].pose_good) << i;
  ASSERT_TRUE(records[199].pose_good);
  EXPECT_EQ(records[199].map_id, 1);
  EXPECT_EQ(told, (std::vector<EventKind>{EventKind::initialized, EventKind::lost, EventKind::reset,
                                          EventKind::initialized}));
  EXPECT_EQ(mainMap(records), 1);
  const auto error = evaluate(scene.desk->groundTruth(), [&] {
    Trajectory estimate = estimateOf(records);
    for (StampedPose& pose : estimate) pose.timestamp -= 2.0;
    return estimate;
  }());
  ASSERT_TRUE(error.ok());
  EXPECT_LT(error.value().ate.rmse, 0.01);
}

TEST(Tracker, TheOldMapIsKeptUntilAnotherHasBegun) {
  // Lost for longer than the patience with the map, in the dark: nothing else starts there.
  const TrackedRun run =
      trackText("synthetic:room?size=320x240&frames=150&speed=0.4&blackout=50:80");
  ASSERT_GE(run.first_pose, 0);
  ASSERT_LT(run.first_pose, 50);
  EXPECT_EQ(run.count(EventKind::reset), 0);
  EXPECT_EQ(run.count(EventKind::relocalized), 1);
  EXPECT_TRUE(run.records[130].relocalized);
  EXPECT_EQ(run.records.back().map_id, 0);
}

TEST(Tracker, OneAdjustmentAtATime) {
  const auto sequence = test::openBuiltIn("synthetic:room?size=320x240&frames=100&speed=2");
  TrackerParameters p;
  p.keyframe.enough_landmarks = 2000;  // a keyframe whenever the camera has moved
  p.keyframe.few_landmarks = 2000;
  p.keyframe.min_frames = 4;
  Tracker tracker(sequence->camera().pinhole, p);
  std::optional<MappingResult> held;
  int keyframes_meanwhile = 0, next = -1;
  for (int i = 0; i < sequence->size() && next < 0; ++i) {
    const SequenceImage image = sequence->read(i).value();
    tracker.process(i, image.timestamp, image.gray);
    auto job = tracker.takeMappingJob();
    if (!job) continue;
    if (held && keyframes_meanwhile < 2) {
      EXPECT_TRUE(job->adjustment.empty()) << "frame " << i;
      keyframes_meanwhile += tracker.record().is_keyframe;
      continue;
    }
    if (held && tracker.map().keyframes.size() > 2 && !job->adjustment.empty())
      next = job->adjustment.newest;
    MappingResult result = runMappingJob(*job, p.mapping);
    if (!held && !job->adjustment.empty())
      held = std::move(result);
    else
      tracker.applyMapping(std::move(result));
    if (held && keyframes_meanwhile == 2) tracker.applyMapping(*held);
  }
  EXPECT_EQ(keyframes_meanwhile, 2);
  EXPECT_EQ(next, tracker.map().keyframes.rbegin()->first) << "the newest gets its turn";
}

TEST(Tracker, StandingSaysNothingAboutDepth) {
  test::ChangedSequence sequence(test::openBuiltIn("synthetic:room?size=320x240&frames=60&noise=2"),
                                 nullptr);
  Tracker tracker(sequence.camera().pinhole, {});
  const TrackedRun run = track(tracker, sequence);
  ASSERT_TRUE(run.records.back().pose_good);
  const cv::Mat last = sequence.read(59).value().gray;
  cv::RNG noise(7);
  int rejected = 0;
  for (int i = 60; i < 300; ++i) {
    cv::Mat image, grain(last.size(), CV_16SC1);
    noise.fill(grain, cv::RNG::NORMAL, 0, 2);
    cv::add(last, grain, image, cv::noArray(), CV_8U);
    tracker.process(i, i / 30.0, image);
    if (const auto job = tracker.takeMappingJob())
      tracker.applyMapping(runMappingJob(*job, tracker.parameters().mapping));
    rejected += tracker.record().seeds_rejected;
    ASSERT_TRUE(tracker.record().pose_good) << i;
    EXPECT_FALSE(tracker.record().is_keyframe) << i << ": " << tracker.record().keyframe_reason;
  }
  EXPECT_LE(rejected, 20);
}

TEST(Tracker, TheMapKeepsItsKeyframeLimitAndItsOrder) {
  const auto sequence = test::openBuiltIn("synthetic:room?size=320x240&frames=60&speed=2");
  TrackerParameters p;
  p.keyframe.max_keyframes = 3;
  Tracker tracker(sequence->camera().pinhole, p);
  const TrackedRun run = track(tracker, *sequence);
  ASSERT_GT(run.good(), 10);
  EXPECT_GT(tracker.map().next_keyframe_id, 3);
  EXPECT_LE(tracker.map().keyframes.size(), 3u);
  for (const auto& [id, keyframe] : tracker.map().keyframes) {
    for (const std::int64_t seen : keyframe.landmarks) EXPECT_NE(tracker.map().find(seen), nullptr);
  }
  for (const auto& [id, landmark] : tracker.map().landmarks) {
    EXPECT_GE(landmark.observations.size(), 2u);
    for (const LandmarkObservation& o : landmark.observations)
      EXPECT_TRUE(tracker.map().keyframes.count(o.keyframe_id));
  }
}

}  // namespace
}  // namespace svoscope
