// SPDX-License-Identifier: MIT
#include "engine/runner/sync_runner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/memory_sequence.h"

namespace svoscope {
namespace {

using Kind = Command::Kind;

constexpr const char* kRoom = "synthetic:room?size=320x240&frames=50";

std::unique_ptr<Runner> makeSync(const std::string& spec, RunnerOptions options = {},
                                 std::set<int> unreadable = {}) {
  options.threaded = false;
  auto sequence = std::make_unique<test::ChangedSequence>(test::openBuiltIn(spec), nullptr,
                                                          std::move(unreadable));
  return std::move(makeRunner(std::move(sequence), options).value());
}

/// Sends a command and pumps until the runner rests; frames processed.
int run(Runner& runner, const Command& command) {
  runner.send(command);
  int frames = 0;
  while (runner.pump()) ++frames;
  return frames;
}

bool hasEvent(const Runner& runner, EventKind kind, const std::string& text = "") {
  for (const Event& e : runner.events(0))
    if (e.kind == kind && e.text.find(text) != std::string::npos) return true;
  return false;
}

void expectSameRecords(const Runner& a, const Runner& b) {
  const auto ra = a.records(0), rb = b.records(0);
  ASSERT_EQ(ra.size(), rb.size());
  int good = 0;
  for (std::size_t i = 0; i < ra.size(); ++i) {
    good += ra[i].pose_good;
    EXPECT_EQ(ra[i].pose_good, rb[i].pose_good) << i;
    EXPECT_EQ(ra[i].T_world_cam.matrix(), rb[i].T_world_cam.matrix()) << i;  // exactly
    EXPECT_EQ(ra[i].funnel.inliers, rb[i].funnel.inliers) << i;
    EXPECT_EQ(ra[i].seeds, rb[i].seeds) << i;
    EXPECT_EQ(ra[i].keyframe_id, rb[i].keyframe_id) << i;
  }
  EXPECT_GT(good, 10);
}

TEST(SyncRunner, TwoRunsAreBitIdentical) {
  const auto a = makeSync(kRoom), b = makeSync(kRoom);
  EXPECT_EQ(run(*a, {Kind::play, -1, "", ""}), 50);
  b->send({Kind::play, -1, "", ""});
  for (int i = 0; i < 20; ++i) b->pump();
  run(*b, {Kind::pause, -1, "", ""});  // a pause in between changes nothing
  run(*b, {Kind::play, -1, "", ""});
  expectSameRecords(*a, *b);
  EXPECT_TRUE(a->status().finished);
  EXPECT_FALSE(a->status().playing);
  EXPECT_TRUE(hasEvent(*a, EventKind::finished));
}

TEST(SyncRunner, ResetRunsTheSameAgain) {
  const auto once = makeSync(kRoom), twice = makeSync(kRoom);
  run(*once, {Kind::play, -1, "", ""});
  run(*twice, {Kind::run_to_frame, 35, "", ""});
  EXPECT_EQ(twice->generation(), 0);
  EXPECT_EQ(run(*twice, {Kind::reset, -1, "", ""}), 0);
  EXPECT_EQ(twice->generation(), 1);
  EXPECT_TRUE(twice->records(0).empty());
  EXPECT_EQ(twice->latest(), nullptr);
  EXPECT_EQ(twice->status().next_frame, 0);
  run(*twice, {Kind::play, -1, "", ""});
  expectSameRecords(*once, *twice);
}

TEST(SyncRunner, CommandsStopWhereTheySay) {
  const auto runner = makeSync(kRoom);
  EXPECT_FALSE(runner->pump());
  EXPECT_EQ(runner->latest(), nullptr);
  EXPECT_EQ(run(*runner, {Kind::step, -1, "", ""}), 1);
  EXPECT_EQ(run(*runner, {Kind::run_to_frame, 4, "", ""}), 4);
  EXPECT_EQ(runner->latest()->record.index, 4);
  run(*runner, {Kind::run_to_start, -1, "", ""});
  EXPECT_TRUE(hasEvent(*runner, EventKind::initialized));
  EXPECT_TRUE(runner->latest()->record.pose_good);
  run(*runner, {Kind::run_to_keyframe, -1, "", ""});
  EXPECT_TRUE(runner->latest()->record.is_keyframe || runner->status().finished);
  const int before = runner->status().next_frame;
  EXPECT_EQ(run(*runner, {Kind::play, -1, "", ""}), 50 - before);
}

TEST(SyncRunner, TwoStepsAreTwoFrames) {
  const auto runner = makeSync(kRoom);
  runner->send({Kind::step, -1, "", ""});
  EXPECT_EQ(run(*runner, {Kind::step, -1, "", ""}), 2);
}

TEST(SyncRunner, RunsToTheLoss) {
  const auto runner = makeSync("synthetic:room?size=320x240&frames=60&blackout=50:5");
  run(*runner, {Kind::run_to_loss, -1, "", ""});
  EXPECT_EQ(runner->latest()->record.index, 50);
  EXPECT_EQ(runner->latest()->record.state, TrackingState::lost);
  EXPECT_TRUE(hasEvent(*runner, EventKind::lost));
}

TEST(SyncRunner, ParametersTakeEffectOrWarn) {
  const auto runner = makeSync(kRoom);
  run(*runner, {Kind::set_parameter, -1, "reproject.max_features", "45"});
  run(*runner, {Kind::set_parameter, -1, "reproject.max_features", "5"});
  run(*runner, {Kind::set_parameter, -1, "no.such", "5"});
  EXPECT_TRUE(hasEvent(*runner, EventKind::warning, "allowed are 20"));
  EXPECT_TRUE(hasEvent(*runner, EventKind::warning, "no.such"));
  for (const ParameterView& view : runner->parameters()) {
    if (view.key == "reproject.max_features") {
      EXPECT_EQ(view.value, "45");
    }
  }
  run(*runner, {Kind::play, -1, "", ""});
  int most = 0;
  for (const FrameRecord& r : runner->records(0)) most = std::max(most, r.funnel.matched);
  EXPECT_EQ(most, 45);
}

TEST(SyncRunner, TheHistoryKeepsItsBudget) {
  RunnerOptions options;
  options.history_budget = 1u << 20;  // about eight frames of 320 x 240 with their pyramids
  const auto runner = makeSync(kRoom, options);
  run(*runner, {Kind::play, -1, "", ""});
  const RunnerStatus status = runner->status();
  EXPECT_LE(status.history_bytes, status.history_budget);
  EXPECT_GT(status.history_first, 20);
  EXPECT_EQ(runner->at(0), nullptr);
  ASSERT_NE(runner->at(49), nullptr);
  EXPECT_EQ(runner->at(status.history_first)->record.index, status.history_first);
  EXPECT_EQ(runner->records(0).size(), 50u);  // rows are never dropped
}

TEST(SyncRunner, AnUnreadableFrameIsAWarningAndARow) {
  const auto runner = makeSync(kRoom, {}, {0, 45});
  run(*runner, {Kind::play, -1, "", ""});
  const auto records = runner->records(0);
  ASSERT_EQ(records.size(), 50u);
  for (const int i : {0, 45}) {
    const FrameRecord& r = records[static_cast<std::size_t>(i)];
    EXPECT_EQ(r.index, i);
    EXPECT_FALSE(r.pose_good);
    EXPECT_EQ(r.reason, "image not readable");
    ASSERT_NE(runner->at(i), nullptr);
  }
  EXPECT_TRUE(hasEvent(*runner, EventKind::warning, "frame.png"));
  EXPECT_FALSE(hasEvent(*runner, EventKind::lost));
  EXPECT_TRUE(records[44].pose_good);
  EXPECT_TRUE(records[46].pose_good);
}

TEST(SyncRunner, SnapshotNumbersIncrease) {
  const auto runner = makeSync(kRoom, {}, {3});
  run(*runner, {Kind::run_to_frame, 6, "", ""});
  for (int i = 1; i <= 6; ++i)
    EXPECT_GT(runner->at(i)->sequence_number, runner->at(i - 1)->sequence_number) << i;
}

TEST(SyncRunner, WithoutPublishingThereIsASnapshotAtPauseAndEnd) {
  RunnerOptions options;
  options.publish_snapshots = false;
  const auto runner = makeSync(kRoom, options);
  runner->send({Kind::play, -1, "", ""});
  for (int i = 0; i < 5; ++i) runner->pump();
  EXPECT_EQ(runner->latest(), nullptr);
  run(*runner, {Kind::pause, -1, "", ""});
  ASSERT_NE(runner->latest(), nullptr);
  EXPECT_EQ(runner->latest()->record.index, 4);
  run(*runner, {Kind::reset, -1, "", ""});
  run(*runner, {Kind::pause, -1, "", ""});
  EXPECT_EQ(runner->latest(), nullptr);  // nothing processed since the reset
  run(*runner, {Kind::play, -1, "", ""});
  EXPECT_EQ(runner->latest()->record.index, 49);
}

TEST(SyncRunner, StartAndEndAreRespected) {
  RunnerOptions options;
  options.start = 7;
  options.max_frames = 5;
  const auto runner = makeSync(kRoom, options);
  EXPECT_EQ(run(*runner, {Kind::play, -1, "", ""}), 5);
  EXPECT_EQ(runner->records(0).front().index, 7);
  EXPECT_EQ(runner->records(0).back().index, 11);
  EXPECT_EQ(run(*runner, {Kind::play, -1, "", ""}), 0);
  EXPECT_EQ(run(*runner, {Kind::step, -1, "", ""}), 0);
  EXPECT_FALSE(runner->status().playing);
}

TEST(MakeRunner, RefusesWhatCannotRun) {
  const auto error = [](RunnerOptions options) {
    const auto made = makeRunner(test::openBuiltIn(kRoom), options);
    return made.ok() ? std::string("ok") : made.error().message();
  };
  RunnerOptions options;
  options.threaded = false;
  EXPECT_EQ(error(options), "ok");
  options.start = 50;
  EXPECT_THAT(error(options), testing::HasSubstr("50 frames"));
  options.start = 0;
  options.method = "orb";
  EXPECT_THAT(error(options), testing::HasSubstr("'orb'"));
}

}  // namespace
}  // namespace svoscope
