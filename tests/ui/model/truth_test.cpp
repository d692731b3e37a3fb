// SPDX-License-Identifier: MIT
#include "ui/model/truth.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/fake_runner.h"
#include "tests/support/scripted_runner.h"
#include "ui/model/run_cache.h"
#include "ui/palette.h"

namespace svoscope::ui {
namespace {

TEST(Truth, FindsTheScale) {
  FakeRunner runner;
  runner.runTo(130);
  const auto records = runner.records(0);
  const TruthState sim3 = alignTruth(records, runner.info().ground_truth, Alignment::sim3);
  ASSERT_TRUE(sim3.valid);
  EXPECT_NEAR(sim3.scale, 1.7, 0.05);
  EXPECT_LT(sim3.ate_rmse, 0.1);
  EXPECT_EQ(sim3.error.size(), records.size());
  EXPECT_TRUE(std::isnan(sim3.error[0])) << "no pose before the start";
  const TruthState se3 = alignTruth(records, runner.info().ground_truth, Alignment::se3);
  EXPECT_EQ(se3.scale, 1);
  EXPECT_GT(se3.ate_rmse, sim3.ate_rmse);
}

TEST(Truth, BringsGroundTruthIntoTheMap) {
  FakeRunner runner;
  runner.runTo(100);
  const auto records = runner.records(0);
  const TruthState s = alignTruth(records, runner.info().ground_truth, Alignment::sim3);
  ASSERT_EQ(s.path.size(), 100u);
  EXPECT_LT((s.path[60].cast<double>() - records[60].T_world_cam.translation()).norm(), 0.1);
}

TEST(Truth, WithoutGroundTruthThereIsNothing) {
  FakeRunner runner;
  runner.runTo(30);
  EXPECT_FALSE(alignTruth(runner.records(0), {}, Alignment::sim3).valid);
  EXPECT_FALSE(alignTruth({}, runner.info().ground_truth, Alignment::sim3).valid);
}

TEST(Truth, WithoutAPoseItSaysSo) {
  FakeOptions options;
  options.start = 1000;
  options.lost_to = 0;
  FakeRunner runner(options);
  runner.runTo(30);
  const TruthState s = alignTruth(runner.records(0), runner.info().ground_truth, Alignment::sim3);
  EXPECT_FALSE(s.valid);
  EXPECT_EQ(s.problem, "no frame has a pose yet") << "the timestamps are not to blame";
}

TEST(RunCache, TheThresholdIsThatOfTheLastFrameHeldAgainstIt) {
  std::vector<FrameRecord> rows = test::fakeRecords(13);
  for (FrameRecord& r : rows) r.funnel.required = r.pose_good ? 40 : 0;
  rows[12].funnel.required = 60;  // relocalization needs more
  test::ScriptedRunner runner(rows);
  runner.send({Command::Kind::play, -1, "", ""});
  while (runner.pump()) {
  }
  RunCache run;
  run.update(runner);
  EXPECT_EQ(run.requiredAt(1), 0) << "before the start";
  EXPECT_EQ(run.requiredAt(5), 40);
  EXPECT_EQ(run.requiredAt(11), 40) << "lost";
  EXPECT_EQ(run.requiredAt(12), 40);
}

TEST(Palette, StatesAreNamedOnce) {
  FrameRecord r;
  r.state = TrackingState::lost;
  r.reason = "lost, no keyframe looks like this frame";
  EXPECT_EQ(stateSentence(r), "Lost: no keyframe looks like this frame");
  r.reason = "31 inliers < 40 required";
  EXPECT_EQ(stateSentence(r), "Lost: 31 inliers < 40 required");
  r.state = TrackingState::tracking;
  r.reason = "tracking";
  EXPECT_EQ(stateSentence(r), "Tracking");
  EXPECT_EQ(stateReason(r), "");
}

TEST(RunCache, FetchesIncrementallyAndStartsAgainAfterReset) {
  FakeRunner runner;
  runner.runTo(20);
  RunCache run;
  EXPECT_TRUE(run.update(runner));
  runner.runTo(30);
  EXPECT_FALSE(run.update(runner));
  ASSERT_EQ(run.records().size(), 30u);
  EXPECT_EQ(run.frames().size(), run.column(0).size());
  ASSERT_TRUE(run.find(25));
  EXPECT_EQ(run.find(25)->index, 25);
  EXPECT_FALSE(run.find(30));
  Command reset;
  reset.kind = Command::Kind::reset;
  runner.send(reset);
  EXPECT_TRUE(run.update(runner));
  EXPECT_TRUE(run.records().empty());
}

TEST(Palette, RampsEndWhereTheyShould) {
  EXPECT_EQ(viridis(0), IM_COL32(68, 1, 84, 255));
  EXPECT_EQ(viridis(1), IM_COL32(253, 231, 37, 255));
  EXPECT_EQ(viridis(2), viridis(1));
  EXPECT_EQ(viridis(NAN), okabe::grey);
}

TEST(Palette, MethodsHaveTheirOwnColour) {
  EXPECT_NE(methodColor("svo"), methodColor("pl-svo"));
  EXPECT_NE(methodColor("svo"), methodColor("it-svo"));
  EXPECT_NE(methodColor("pl-svo"), methodColor("it-svo"));
}

}  // namespace
}  // namespace svoscope::ui
