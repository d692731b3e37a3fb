// SPDX-License-Identifier: MIT
#include "ui/host_pacing.h"

#include <gtest/gtest.h>

namespace svoscope::ui {
namespace {

/// Frames drawn in ten seconds of a situation, each costing `cost` seconds.
int framesIn10s(bool software, const FramePacer::Situation& situation, double cost) {
  FramePacer pacer(software);
  int frames = 0;
  for (double t = 0; t < 10;) {
    if (pacer.due(situation, t)) {
      t += cost;
      pacer.drawn(situation, t, cost);
      ++frames;
    } else {
      t += pacer.patience(situation, t);
    }
  }
  return frames;
}

TEST(FramePacer, AGpuDrawsSixtyTimesASecondOnlyWhileSomethingMoves) {
  EXPECT_NEAR(framesIn10s(false, {false, true, true}, 0.001), 590, 40);
  EXPECT_LE(framesIn10s(false, {}, 0.001), 30);
}

TEST(FramePacer, SoftwareRenderingLeavesTheEngineItsCores) {
  EXPECT_LE(framesIn10s(true, {false, true, true}, 0.01), 101);
  EXPECT_LE(framesIn10s(true, {false, true, true}, 0.1) * 0.1, 2.1) << "a fifth of one core";
  EXPECT_LE(framesIn10s(true, {}, 0.05), 15);
}

TEST(FramePacer, InputIsAnsweredSoonEvenThen) {
  FramePacer pacer(true);
  const FramePacer::Situation playing{false, true, true}, input{true, true, true};
  for (int i = 0; i < 5; ++i) pacer.drawn(playing, 1, 0.005);
  EXPECT_FALSE(pacer.due(playing, 1.06));
  EXPECT_TRUE(pacer.due(input, 1.06));
}

}  // namespace
}  // namespace svoscope::ui
