// SPDX-License-Identifier: MIT
#include "engine/runner/lockstep_runner.h"

#include <gtest/gtest.h>

#include <thread>

#include "engine/runner/serialized_runner.h"
#include "engine/runner/trajectory_runner.h"
#include "tests/support/fake_runner.h"

namespace svoscope {
namespace {

using Kind = Command::Kind;

FakeOptions fake(const std::string& method, int start, int frames = 60) {
  FakeOptions options;
  options.method = method;
  options.start = start;
  options.frames = frames;
  options.landmarks = 60;
  options.seeds = 20;
  options.width = 160;
  options.height = 120;
  options.lost_from = 40;
  options.lost_to = 42;
  return options;
}

class Lockstep : public ::testing::Test {
 protected:
  void add(const FakeOptions& options) {
    members_.push_back({std::make_unique<FakeRunner>(options), options.method, false});
  }
  void open(LockstepRunner::Drive drive = LockstepRunner::Drive::by_pump) {
    runs_ = std::make_unique<LockstepRunner>(std::move(members_), drive);
  }
  void send(Kind kind, int frame = -1) {
    Command command;
    command.kind = kind;
    command.frame = frame;
    runs_->send(command);
  }
  /// Until nothing is done any more.
  void work() {
    for (Stopwatch watch; watch.ms() < 20000 && (runs_->pump() || runs_->status().playing);) {
    }
  }
  void expectAligned(int frame) {
    EXPECT_EQ(runs_->frame(), frame);
    for (int i = 0; i < runs_->size(); ++i) {
      const RunView& run = runs_->run(i);
      ASSERT_TRUE(run.latest()) << runs_->label(i);
      EXPECT_EQ(run.latest()->record.index, frame) << runs_->label(i);
      EXPECT_EQ(static_cast<int>(run.records(0).size()), frame + 1) << runs_->label(i);
    }
  }
  std::vector<LockstepMember> members_;
  std::unique_ptr<LockstepRunner> runs_;
};

TEST_F(Lockstep, EveryRunStandsAtTheSameFrame) {
  add(fake("svo", 5));
  add(fake("pl-svo", 12));
  add(fake("it-svo", 8));
  open();
  EXPECT_EQ(runs_->frame(), -1);
  EXPECT_FALSE(runs_->latest());
  send(Kind::step);
  work();
  expectAligned(0);
  send(Kind::step);
  send(Kind::step);
  work();
  expectAligned(2);
  send(Kind::run_to_frame, 30);
  work();
  expectAligned(30);
  send(Kind::play);
  work();
  expectAligned(59);
  EXPECT_TRUE(runs_->status().finished);
  EXPECT_FALSE(runs_->status().playing);
}

TEST_F(Lockstep, NothingIsSeenOfAFrameBeforeAllRunsHaveIt) {
  add(fake("svo", 5));
  add(fake("it-svo", 8));
  open();
  send(Kind::run_to_frame, 20);
  while (runs_->frame() < 20) {
    ASSERT_TRUE(runs_->pump());
    for (int i = 0; i < 2; ++i) {
      const RunView& run = runs_->run(i);
      EXPECT_EQ(static_cast<int>(run.records(0).size()), runs_->frame() + 1);
      EXPECT_FALSE(run.at(runs_->frame() + 1));
      for (const Event& event : run.events(0)) EXPECT_LE(event.frame_index, runs_->frame());
      if (runs_->frame() >= 0) {
        EXPECT_EQ(run.latest()->record.index, runs_->frame());
      }
    }
  }
}

TEST_F(Lockstep, GoalsAreThoseOfTheCurrentRun) {
  add(fake("svo", 5));
  add(fake("it-svo", 8));
  open();
  send(Kind::run_to_start);
  work();
  expectAligned(5);
  ASSERT_TRUE(runs_->setCurrent(1));
  send(Kind::run_to_start);
  work();
  expectAligned(8);
  send(Kind::run_to_keyframe);
  work();
  expectAligned(17);  // every ninth frame after the start
  EXPECT_TRUE(runs_->latest()->record.is_keyframe);
  EXPECT_FALSE(runs_->run(0).latest()->record.is_keyframe);
  send(Kind::run_to_loss);
  work();
  expectAligned(40);
}

TEST_F(Lockstep, ResetStartsAllAgain) {
  add(fake("svo", 5));
  add(fake("it-svo", 8));
  open();
  send(Kind::run_to_frame, 25);
  work();
  const int before = runs_->generation();
  send(Kind::reset);
  work();
  EXPECT_EQ(runs_->frame(), -1);
  EXPECT_EQ(runs_->generation(), before + 1);
  for (int i = 0; i < 2; ++i) EXPECT_TRUE(runs_->run(i).records(0).empty());
  send(Kind::step);
  work();
  expectAligned(0);
}

TEST_F(Lockstep, APauseWaitsForTheRunsThatStillHaveToFinishTheFrame) {
  add(fake("svo", 5));
  add(fake("it-svo", 8));
  open();
  send(Kind::play);
  for (int i = 0; i < 21; ++i) runs_->pump();  // in the middle of a frame
  send(Kind::pause);
  work();
  expectAligned(runs_->frame());
  EXPECT_GE(runs_->frame(), 10);
  EXPECT_FALSE(runs_->status().playing);
}

TEST_F(Lockstep, AShorterRunEndsAndTheOthersGoOn) {
  add(fake("svo", 5, 60));
  add(fake("recorded", 5, 20));
  open();
  send(Kind::play);
  work();
  EXPECT_EQ(runs_->frame(), 59);
  EXPECT_EQ(runs_->run(0).records(0).size(), 60u);
  EXPECT_EQ(runs_->run(1).records(0).size(), 20u);
  EXPECT_EQ(runs_->run(1).latest()->record.index, 19);
  EXPECT_FALSE(runs_->run(1).at(59));
  EXPECT_TRUE(runs_->status().finished);
}

/// Takes commands and never processes anything.
class DeadRunner : public FakeRunner {
 public:
  DeadRunner() : FakeRunner(fake("dead", 5)) {}
  void send(const Command&) override {}
};

TEST_F(Lockstep, ARunThatDoesNothingDoesNotHoldUpTheOthers) {
  add(fake("svo", 5));
  members_.push_back({std::make_unique<DeadRunner>(), "dead", false});
  open();
  send(Kind::step);
  work();
  EXPECT_EQ(runs_->frame(), 0);
  EXPECT_FALSE(runs_->run(1).latest());
  send(Kind::run_to_frame, 10);
  work();
  EXPECT_EQ(runs_->frame(), 10);
}

TEST_F(Lockstep, ParametersBelongToTheCurrentRunSpeedToNone) {
  add(fake("svo", 5));
  add(fake("it-svo", 8));
  open();
  ASSERT_TRUE(runs_->setCurrent(1));
  Command set;
  set.kind = Kind::set_parameter;
  set.key = "tracking.min_inliers";
  set.value = "55";
  runs_->send(set);
  work();
  EXPECT_EQ(runs_->run(1).parameters().front().value, "55");
  EXPECT_EQ(runs_->run(0).parameters().front().value, "40");
  EXPECT_FALSE(runs_->setCurrent(2));
  EXPECT_FALSE(runs_->setCurrent(-1));
}

TEST_F(Lockstep, HistoryIsCountedTogether) {
  add(fake("svo", 5));
  add(fake("it-svo", 8));
  open();
  send(Kind::run_to_frame, 3);
  work();
  EXPECT_EQ(runs_->status().history_bytes, 8u * 600000);
}

TEST_F(Lockstep, AThreadOfItsOwnKeepsRunsTogether) {
  for (const char* method : {"svo", "it-svo"}) {
    members_.push_back(
        {std::make_unique<SerializedRunner>(std::make_unique<FakeRunner>(fake(method, 5))), method,
         false});
  }
  open(LockstepRunner::Drive::by_thread);
  EXPECT_FALSE(runs_->pump());
  send(Kind::run_to_frame, 30);
  while (runs_->status().playing) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  expectAligned(30);
  send(Kind::play);
  send(Kind::pause);
  send(Kind::step);
  send(Kind::reset);
  while (runs_->status().playing) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(runs_->frame(), -1);
  send(Kind::play);  // and is destroyed in the middle of it
}

TrajectoryFile fileOf(const std::vector<double>& times) {
  TrajectoryFile file;
  for (const double t : times)
    file.poses.push_back({t, SE3(Eigen::Quaterniond::Identity(), Vec3(t, 0, 0))});
  return file;
}

RunInfo poseInfo() {
  RunInfo info;
  info.sequence = "synthetic:fake";
  info.method = "orb";
  return info;
}

TEST_F(Lockstep, ATrajectoryWithFewerFramesGoesAlong) {
  add(fake("svo", 5));
  std::vector<double> times;
  for (int i = 10; i < 30; ++i) times.push_back(i / 30.0);
  FrameTimes frames;
  for (int i = 0; i < 60; ++i) frames.timestamps.push_back(i / 30.0);
  auto orb = TrajectoryRunner::make(fileOf(times), frames, poseInfo(), "orb.txt");
  ASSERT_TRUE(orb.ok());
  members_.push_back({std::move(orb).value(), "orb", true});
  open();
  EXPECT_FALSE(runs_->setCurrent(1)) << "nothing to inspect";
  send(Kind::play);
  work();
  expectAligned(59);
  const auto rows = runs_->run(1).records(0);
  EXPECT_FALSE(rows[9].pose_good);
  EXPECT_TRUE(rows[10].pose_good);
  EXPECT_FALSE(rows[30].pose_good);
}

}  // namespace
}  // namespace svoscope
