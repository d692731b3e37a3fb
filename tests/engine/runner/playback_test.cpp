// SPDX-License-Identifier: MIT
#include "engine/runner/playback.h"

#include <gtest/gtest.h>

namespace svoscope {
namespace {

using Kind = Command::Kind;

FrameRecord frame(int index) {
  FrameRecord r;
  r.index = index;
  r.state = TrackingState::tracking;
  return r;
}

TEST(Playback, StartsPaused) { EXPECT_FALSE(Playback().wantsFrame()); }

TEST(Playback, AStepIsOneFrame) {
  Playback p;
  p.handle({Kind::step, -1, "", ""});
  EXPECT_TRUE(p.wantsFrame());
  p.processed(frame(0), false);
  EXPECT_FALSE(p.wantsFrame());
}

TEST(Playback, PlaysUntilPausedResetOrFinished) {
  for (const Kind stop : {Kind::pause, Kind::reset}) {
    Playback p;
    p.handle({Kind::play, -1, "", ""});
    for (int i = 0; i < 10; ++i) p.processed(frame(i), i == 4);
    EXPECT_TRUE(p.playing());
    p.handle({stop, -1, "", ""});
    EXPECT_FALSE(p.playing());
  }
  Playback p;
  p.handle({Kind::play, -1, "", ""});
  p.finish();
  EXPECT_FALSE(p.playing());
}

TEST(Playback, RunsToAFrameEvenIfItWasJumpedOver) {
  Playback p;
  p.handle({Kind::run_to_frame, 5, "", ""});
  p.processed(frame(4), false);
  EXPECT_TRUE(p.wantsFrame());
  p.processed(frame(6), false);
  EXPECT_FALSE(p.wantsFrame());
}

TEST(Playback, RunsToKeyframeLossAndStart) {
  Playback p;
  p.handle({Kind::run_to_keyframe, -1, "", ""});
  p.processed(frame(1), true);
  EXPECT_TRUE(p.wantsFrame());
  FrameRecord keyframe = frame(2);
  keyframe.is_keyframe = true;
  p.processed(keyframe, false);
  EXPECT_FALSE(p.wantsFrame());

  p.handle({Kind::run_to_loss, -1, "", ""});
  p.processed(keyframe, true);
  EXPECT_TRUE(p.wantsFrame());
  FrameRecord lost = frame(3);
  lost.state = TrackingState::lost;
  p.processed(lost, false);
  EXPECT_FALSE(p.wantsFrame());

  p.handle({Kind::run_to_start, -1, "", ""});
  p.processed(lost, false);
  EXPECT_TRUE(p.wantsFrame());
  p.processed(frame(4), true);
  EXPECT_FALSE(p.wantsFrame());
}

TEST(Playback, SpeedIsANumberNotBelowZero) {
  Playback p;
  EXPECT_EQ(p.speed(), 0);
  for (const auto& [text, speed] :
       {std::pair("12.5", 12.5), {"-3", 0.0}, {"fast", 0.0}, {"", 0.0}, {"nan", 0.0}}) {
    p.handle({Kind::set_speed, -1, "", text});
    EXPECT_EQ(p.speed(), speed) << text;
  }
}

TEST(Playback, ParametersDoNotDisturbIt) {
  Playback p;
  p.handle({Kind::play, -1, "", ""});
  p.handle({Kind::set_parameter, -1, "reproject.cell_px", "40"});
  p.handle({Kind::set_speed, -1, "", "5"});
  EXPECT_TRUE(p.playing());
}

}  // namespace
}  // namespace svoscope
