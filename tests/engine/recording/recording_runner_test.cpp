// SPDX-License-Identifier: MIT
#include "engine/recording/recording_runner.h"

#include <gtest/gtest.h>

#include "tests/support/recorded_run.h"

namespace svoscope {
namespace {

using Kind = Command::Kind;

const test::RecordedRun& sample() {
  static test::RecordedRun run("synthetic:room?frames=40&size=320x240",
                               test::synchronous("it-svo"));
  static const bool finished = run.finish().ok();
  EXPECT_TRUE(finished);
  return run;
}

struct RecordingRunnerTest : testing::Test {
  void SetUp() override {
    runner = sample().open();
    ASSERT_NE(runner, nullptr);
  }
  void send(Kind kind, int frame = -1) { runner->send({kind, frame, "", ""}); }
  int reached() const {
    const SnapshotPtr latest = runner->latest();
    return latest ? latest->record.index : -1;
  }
  std::unique_ptr<Runner> runner;
};

TEST_F(RecordingRunnerTest, BeginsBeforeTheFirstFrame) {
  EXPECT_EQ(reached(), -1);
  EXPECT_TRUE(runner->records(0).empty());
  EXPECT_TRUE(runner->events(0).empty());
  const RunnerStatus status = runner->status();
  EXPECT_TRUE(status.recorded);
  EXPECT_FALSE(status.finished);
  EXPECT_FALSE(status.playing);
  EXPECT_EQ(status.next_frame, 0);
}

TEST_F(RecordingRunnerTest, StepsAndPlaysToTheEnd) {
  send(Kind::step);
  EXPECT_EQ(reached(), 0);
  EXPECT_FALSE(runner->pump());
  send(Kind::play);
  EXPECT_TRUE(runner->status().playing);
  int frames = 0;
  while (runner->pump()) ++frames;
  EXPECT_EQ(frames, 39);
  EXPECT_EQ(reached(), 39);
  EXPECT_TRUE(runner->status().finished);
  EXPECT_FALSE(runner->status().playing);
  EXPECT_EQ(runner->records(0).size(), 40u);
  EXPECT_EQ(runner->events(0).size(), sample().runner->events(0).size());
  send(Kind::step);  // nothing behind the end
  EXPECT_EQ(reached(), 39);
}

TEST_F(RecordingRunnerTest, RunsToWhatTheEngineWouldRunTo) {
  const auto records = sample().runner->records(0);
  send(Kind::run_to_start);
  const int start = reached();
  EXPECT_GT(start, 0);
  EXPECT_EQ(records[static_cast<std::size_t>(start)].state, TrackingState::tracking);
  EXPECT_EQ(runner->records(0).size(), static_cast<std::size_t>(start) + 1);
  send(Kind::run_to_keyframe);
  EXPECT_TRUE(runner->latest()->record.is_keyframe || runner->status().finished);
  EXPECT_GT(reached(), start);
  send(Kind::run_to_loss);  // there is none
  EXPECT_TRUE(runner->status().finished);
}

TEST_F(RecordingRunnerTest, GoesBackAndKeepsWhatWasReached) {
  send(Kind::run_to_frame, 30);
  EXPECT_EQ(runner->records(0).size(), 31u);
  send(Kind::run_to_frame, 12);
  EXPECT_EQ(reached(), 12);
  EXPECT_EQ(runner->records(0).size(), 31u);
  EXPECT_FALSE(runner->status().finished);
  send(Kind::step);
  EXPECT_EQ(reached(), 13);
  send(Kind::run_to_frame, 1000000);
  EXPECT_EQ(reached(), 39);
}

TEST_F(RecordingRunnerTest, EveryFrameCanBeHadAtAnyTime) {
  EXPECT_EQ(runner->at(39)->record.index, 39);
  EXPECT_NE(runner->at(39)->pyramid, nullptr);
  EXPECT_EQ(runner->at(0)->record.index, 0);
  EXPECT_EQ(runner->valuesAt(20)->record.index, 20);
  EXPECT_EQ(runner->at(40), nullptr);
  EXPECT_EQ(runner->at(-1), nullptr);
  EXPECT_EQ(runner->at(20)->seeds, runner->valuesAt(20)->seeds);  // shared, not read twice
}

TEST_F(RecordingRunnerTest, AResetStartsAgain) {
  send(Kind::run_to_frame, 20);
  const int generation = runner->generation();
  send(Kind::reset);
  EXPECT_NE(runner->generation(), generation);
  EXPECT_EQ(reached(), -1);
  EXPECT_TRUE(runner->records(0).empty());
  EXPECT_TRUE(runner->events(0).empty());
}

TEST_F(RecordingRunnerTest, AParameterIsNotSetAndThatIsSaid) {
  send(Kind::step);
  const auto before = runner->parameters();
  runner->send({Kind::set_parameter, -1, "search.sigmas", "5"});
  const auto after = runner->parameters();
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(before[i].value, after[i].value);
  ASSERT_FALSE(runner->events(0).empty());
  EXPECT_EQ(runner->events(0).back().kind, EventKind::warning);
}

TEST_F(RecordingRunnerTest, PlaysNoFasterThanAsked) {
  runner->send({Kind::set_speed, -1, "", "0.001"});
  send(Kind::play);
  EXPECT_TRUE(runner->pump());   // the first at once
  EXPECT_FALSE(runner->pump());  // the next in a quarter of an hour
  EXPECT_TRUE(runner->status().playing);
  EXPECT_EQ(reached(), 0);
  send(Kind::pause);
  EXPECT_FALSE(runner->status().playing);
}

}  // namespace
}  // namespace svoscope
