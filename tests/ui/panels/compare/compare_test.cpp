// SPDX-License-Identifier: MIT
// Several runs open at once: one transport for all, one current run, the Compare panels.
#include <gmock/gmock.h>

#include <cmath>
#include <opencv2/imgcodecs.hpp>

#include "tests/ui/panels/compare/compare_fixture.h"
#include "ui/palette.h"

namespace svoscope::ui {
namespace {

using testing::HasSubstr;

TEST_P(Compare, OneTransportMovesAllRuns) {
  open();
  EXPECT_EQ(
      run("step 3\nexpect frame@svo == 2\nexpect frame@it-svo == 2\n"
          "run-to start\nexpect frame@svo == 12\nexpect frame@pl-svo == 12\n"
          "run-to keyframe\nexpect frame == 21\nexpect frame@pl-svo == 21\n"
          "back 4\nexpect frame@svo == 17\nexpect frame@pl-svo == 17\nkey left\nexpect "
          "frame@it-svo == 16\n"
          "goto live\nexpect frame@svo == 21\nrun-to lost\nexpect frame@pl-svo == 60\n"
          "reset\nexpect next_frame == 0\nstep\nexpect frame@svo == 0\nexpect frame@it-svo == 0\n"),
      "");
}

TEST_P(Compare, TheCurrentRunIsChosenByKeyTabAndScript) {
  open();
  EXPECT_EQ(
      run("run-to 30\nexpect run == svo\nkey r\nexpect run == pl-svo\nexpect method == pl-svo\n"
          "key r\nexpect run == it-svo\nexpect state == initializing\n"
          "key r\nexpect run == svo\n"  // the trajectory is passed over
          "click run:pl-svo\nexpect run == pl-svo\n"
          "click run:orb\nexpect run == pl-svo\n"
          "run 0\nexpect run == svo\nexpect runs has orb\n"),
      "");
  EXPECT_THAT(run("run orb\n"), HasSubstr("poses only"));
  EXPECT_THAT(run("run dso\n"), HasSubstr("no run is called 'dso'"));
}

TEST_P(Compare, EachRunKeepsItsSelection) {
  open();
  ASSERT_EQ(run("run-to 40\nselect seed any\n"), "");
  const Selection first = inspector->state().selection;
  EXPECT_EQ(run("run pl-svo\nexpect selected.kind == none\nselect feature any\nexpect "
                "selected.kind != none\n"
                "run svo\nexpect selected.kind == seed\n"),
            "");
  EXPECT_EQ(inspector->state().selection, first);
}

TEST_P(Compare, MetricsAreThoseOfEachRun) {
  open();
  ASSERT_EQ(run("run-to 119\nlayout Compare\nwait 3\n"), "");
  const auto& compared = inspector->compare().runs();
  ASSERT_EQ(compared.size(), 4u);
  EXPECT_EQ(*compared[0].metrics.init_frame, 12);
  EXPECT_EQ(*compared[1].metrics.init_frame, 5);
  EXPECT_FALSE(compared[2].metrics.init_frame) << "it never starts";
  EXPECT_FALSE(compared[2].aligned);
  EXPECT_EQ(*compared[3].metrics.init_frame, 20);
  EXPECT_EQ(compared[0].losses.size(), 1u);
  EXPECT_EQ(compared[2].losses.size(), 0u);
  EXPECT_GT(compared[0].truth.ate_rmse, compared[1].truth.ate_rmse);
  EXPECT_LT(compared[3].truth.ate_rmse, 1e-9) << "it is the ground truth";
  EXPECT_EQ(run("expect start_frame@svo == 12\nexpect losses@svo == 1\nexpect ate@orb < 1e-6\n"
                "expect tracked_fraction@svo < 1\nexpect tracked_fraction@it-svo == 0\n"),
            "");
}

TEST_P(Compare, PathsLieInOneFrameOfReference) {
  open();
  ASSERT_EQ(run("run-to 119\nlayout Compare\nwait 3\n"), "");
  const CompareData& data = inspector->compare();
  EXPECT_TRUE(data.metric());
  const ComparedRun &svo = data.runs()[0], &orb = data.runs()[3];
  for (const int row : {30, 50, 70}) {
    const auto i = static_cast<std::size_t>(row);
    EXPECT_NEAR((svo.path[i] - orb.path[i]).norm(), svo.error[i], 1e-3)
        << "orb is the ground truth";
    EXPECT_NEAR(orb.difference[i], (svo.path[i] - orb.path[i]).norm(), 1e-5);
  }
  EXPECT_TRUE(std::isnan(orb.difference[10])) << "the trajectory begins later";
  EXPECT_TRUE(std::isnan(svo.difference[50])) << "the current run is compared with itself";
}

TEST_P(Compare, WithoutGroundTruthRunsAreAlignedToTheCurrentOne) {
  open(false);
  ASSERT_EQ(run("run-to 119\nlayout Compare\nwait 3\nrun pl-svo\nwait 2\n"), "");
  const CompareData& data = inspector->compare();
  EXPECT_FALSE(data.metric());
  EXPECT_TRUE(data.runs()[1].aligned);
  ASSERT_TRUE(data.runs()[0].aligned);
  EXPECT_LT(data.runs()[0].difference[100], 0.2f);
  EXPECT_GT(data.runs()[0].difference[100], 0);
  EXPECT_TRUE(data.runs()[3].aligned) << "in another frame and scale";
  EXPECT_LT(data.runs()[3].difference[50], 0.2f);
}

TEST_P(Compare, EveryLayoutDrawsAtSeveralSizesAndScales) {
  open();
  EXPECT_EQ(
      run("layout Compare\nwait 2\nrun-to 66\nwait 2\nscale 1.5\nwait 2\nsize 640x400\nwait 2\n"
          "size 80x80\nwait 2\nsize 1280x720\nscale 1\npanel Compare images\nwait 2\nclick "
          "image:pl-svo\n"
          "expect run == pl-svo\n"),
      "");
}

INSTANTIATE_TEST_SUITE_P(Surfaces, Compare, testing::Values(SurfaceKind::null, SurfaceKind::osmesa),
                         [](const auto& test) {
                           return test.param == SurfaceKind::null ? "null" : "osmesa";
                         });

TEST(CompareAlone, OneRunSaysHowToOpenMore) {
  const auto host = openHost(SurfaceKind::null, 1280, 720);
  FakeRunner runner;
  Inspector inspector(runner, host->graphics());
  InspectorTarget target(runner, inspector.state());
  const auto script =
      parseScript("step\nlayout Compare\nkey r\nexpect run == it-svo\n", "test.script");
  test::TemporaryFolder folder;
  const auto result = runScript(script.value(), {*host, inspector, target, &runner, folder.path()});
  EXPECT_TRUE(result.ok()) << result.error().message();
  EXPECT_TRUE(inspector.compare().runs().empty());
}

// The colours of the methods are on screen where their names are: a picture that lost a run
// differs.
TEST(CompareAlone, ThePictureHasTheColourOfEveryRun) {
  const auto host = openHost(SurfaceKind::osmesa, 1000, 700);
  if (!host) GTEST_SKIP() << "OSMesa is absent: install libosmesa6";
  std::vector<LockstepMember> members;
  const std::pair<const char*, double> bends[] = {{"svo", 1e-4}, {"pl-svo", -1e-4}, {"it-svo", 0}};
  for (const auto& [method, bend] : bends) {
    members.push_back({std::make_unique<FakeRunner>(fakeRun(method, 5, bend)), method, false});
  }
  LockstepRunner runs(std::move(members), LockstepRunner::Drive::by_pump);
  Inspector inspector(runs, host->graphics());
  InspectorTarget target(runs, inspector.state());
  test::TemporaryFolder folder;
  const auto script = parseScript(
      "run-to 80\npanel Compare 3-D\nset image.seeds off\nwait 2\nshot a.png Compare 3-D\n", "t");
  const auto result = runScript(script.value(), {*host, inspector, target, &runs, folder.path()});
  ASSERT_TRUE(result.ok()) << result.error().message();
  const cv::Mat picture = cv::imread((folder.path() / "a.png").string());
  ASSERT_FALSE(picture.empty());
  for (const char* method : {"svo", "pl-svo", "it-svo"}) {
    const ImVec4 c = toVec4(methodColor(method));
    int pixels = 0;
    for (int y = 0; y < picture.rows; ++y) {
      for (int x = 0; x < picture.cols; ++x) {
        const auto& p = picture.at<cv::Vec3b>(y, x);
        pixels += std::abs(p[2] - 255 * c.x) < 24 && std::abs(p[1] - 255 * c.y) < 24 &&
                  std::abs(p[0] - 255 * c.z) < 24;
      }
    }
    EXPECT_GT(pixels, 60) << method;
  }
}

}  // namespace
}  // namespace svoscope::ui
