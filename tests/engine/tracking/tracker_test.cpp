// SPDX-License-Identifier: MIT
// The whole front end on built-in sequences: start, tracking, loss, recovery.
#include "engine/tracking/tracker.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

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
    return static_cast<int>(std::count_if(events.begin(), events.end(), [&](const Event& e) { return e.kind == kind; }));
  }
  int good() const { return static_cast<int>(estimate.size()); }
  double pathLength() const {
    double length = 0;
    for (std::size_t i = static_cast<std::size_t>(first_pose) + 1; i < truth.size(); ++i)
      length += (truth[i].T_world_cam.translation() - truth[i - 1].T_world_cam.translation()).norm();
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

TrackedRun trackText(const std::string& spec, const test::ChangedSequence::Change& change = nullptr) {
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
TEST(Tracker, FollowsTheDesk) { expectTracked(trackText("synthetic:desk?size=320x240&frames=60"), 60); }

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
  const TrackedRun run = trackText(kRoom, [](int i, cv::Mat& gray) { if (i == 50) gray.setTo(255); });
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

TEST(Tracker, AnOldMapsAnswersDoNotReachTheNewMap) {
  // A young map is given up after a long loss. Identifiers must not return: a mapping answer, or
  // whatever is kept by keyframe, may still speak of the old map.
  const auto sequence = test::openBuiltIn("synthetic:room?size=320x240&frames=120");
  Tracker tracker(sequence->camera().pinhole, {});
  int start = -1, newest = -1;
  std::int64_t newest_point = -1;
  const cv::Mat black(240, 320, CV_8UC1, cv::Scalar(0));
  bool again = false;
  for (int i = 0; i < 120 && !again; ++i) {
    const bool dark = start >= 0 && i > start && i <= start + 14;
    const SequenceImage image = sequence->read(i).value();
    tracker.process(i, image.timestamp, dark ? black : image.gray);
    for (const Event& e : tracker.events()) {
      if (e.kind != EventKind::initialized) continue;
      if (start >= 0) again = true;
      else start = i;
    }
    if (again) break;
    for (const auto& [id, keyframe] : tracker.map().keyframes) newest = std::max(newest, id);
    for (const auto& [id, landmark] : tracker.map().landmarks) newest_point = std::max(newest_point, id);
  }
  ASSERT_TRUE(again);
  for (const auto& [id, keyframe] : tracker.map().keyframes) EXPECT_GT(id, newest);
  for (const auto& [id, landmark] : tracker.map().landmarks) EXPECT_GT(id, newest_point);
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
    for (const LandmarkObservation& o : landmark.observations) EXPECT_TRUE(tracker.map().keyframes.count(o.keyframe_id));
  }
}

}  // namespace
}  // namespace svoscope
