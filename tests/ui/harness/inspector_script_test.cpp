// SPDX-License-Identifier: MIT
// The inspector driven by scripts, as a user would: on the null surface for logic, on OSMesa once
// more with pixels.
#include <gmock/gmock.h>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "tests/support/fake_runner.h"
#include "tests/support/support.h"
#include "tests/ui/render/render_fixture.h"
#include "ui/application.h"
#include "ui/harness/executor.h"
#include "ui/harness/inspector_target.h"
#include "ui/inspector.h"
#include "ui/panels/panel.h"

namespace svoscope::ui {
namespace {

using testing::HasSubstr;

class InspectorScript : public testing::TestWithParam<SurfaceKind> {
 protected:
  void SetUp() override {
    host = openHost(GetParam(), 800, 600);
    if (!host) GTEST_SKIP() << "OSMesa is absent: install libosmesa6";
    inspector = std::make_unique<Inspector>(runner, host->graphics());
  }
  std::string run(const std::string& text) {
    const Result<Script> script = parseScript(text, "test.script");
    if (!script) return script.error().message();
    InspectorTarget target(runner, inspector->state());
    const auto result =
        runScript(script.value(), {*host, *inspector, target, &runner, folder.path()});
    return result ? "" : result.error().message();
  }
  test::TemporaryFolder folder;
  FakeRunner runner;
  std::unique_ptr<Host> host;
  std::unique_ptr<Inspector> inspector;
};

TEST_P(InspectorScript, StepsScrubsAndRuns) {
  EXPECT_EQ(run("step 3\nexpect frame == 2\n"
                "run-to start\nexpect state == tracking\n"
                "run-to keyframe\nexpect is_keyframe == true\n"
                "run-to 40\nexpect frame == 40\nback 5\nexpect frame == 35\nexpect live == false\n"
                "goto live\nexpect frame == 40\nkey space\nwait 5\nexpect playing == true\n"
                "key space\nwait 2\nexpect playing == false\n"
                "run-to lost\nexpect state == lost\n"),
            "");
}

TEST_P(InspectorScript, SelectsFeaturesAndSeeds) {
  EXPECT_EQ(run("run-to 60\nselect feature any\nexpect selected.kind != none\n"
                "select none\nexpect selected.kind == none\n"
                "select seed any\nexpect selected.kind == seed\nexpect seed.visible == 1\n"
                "expect seed.status == active\nexpect seed.outcome == matched\n"),
            "");
}

TEST_P(InspectorScript, AnyOrNoneDoesNotEndTheScript) {
  EXPECT_EQ(run("run-to 60\nselect seed any or none\nexpect selected.kind == seed\n"), "");
  EXPECT_EQ(run("goto 0\nselect seed any or none\nexpect selected.kind == none\n"), "");
  EXPECT_NE(run("goto 0\nselect seed any\n"), "");
  EXPECT_NE(run("select seed any or all\n"), "");
}

TEST_P(InspectorScript, SelectsByAClickOnTheImage) {
  ASSERT_EQ(run("size 1280x800\nrun-to 60\nwait 2\n"), "");
  const SnapshotPtr latest = runner.latest();
  for (const FeatureView& feature : latest->features) {
    if (feature.status != FeatureStatus::inlier || feature.type != FeatureType::corner) continue;
    const std::string place = std::to_string(feature.px.x()) + " " + std::to_string(feature.px.y());
    EXPECT_EQ(run("select at " + place + "\nexpect selected.kind != none\n"), "");
    return;
  }
  FAIL() << "no feature to click on";
}

TEST_P(InspectorScript, AShotSaysWhyAPanelIsNotThere) {
  EXPECT_THAT(run("step\nshot a.png Log\n"), HasSubstr("the panel Log is behind its tab"));
  EXPECT_THAT(run("shot a.png Seed\n"), HasSubstr("not in the layout Tracking"));
  EXPECT_THAT(run("shot a.png Lgo\n"), HasSubstr("no panel is called 'Lgo'"));
  EXPECT_THAT(run("panel Image\nshot a.png Funnel\n"), HasSubstr("Image is shown alone"));
  EXPECT_EQ(run("panel all\nclick tab:Log\nshot a.png Log\n"), "");
}

TEST_P(InspectorScript, EveryPanelAndLayoutDrawsAtSeveralSizesAndScales) {
  ASSERT_EQ(run("run-to 60\nselect feature any\n"), "");
  for (const std::string& layout : presetNames())
    EXPECT_EQ(run("layout \"" + layout + "\"\nwait 2\nshot l\n"), "") << layout;
  for (const Panel* each : panels()) {
    const std::string panel = each->name;
    EXPECT_EQ(run("panel \"" + panel + "\"\nwait 2\nexpect labels has \"panel:" + panel + "\"\n"),
              "");
  }
  EXPECT_EQ(run("panel all\nscale 2\nwait 2\nsize 320x200\nwait 2\nsize 80x80\nwait 2\n"), "");
}

INSTANTIATE_TEST_SUITE_P(Surfaces, InspectorScript,
                         testing::Values(SurfaceKind::null, SurfaceKind::osmesa),
                         [](const auto& test) {
                           return test.param == SurfaceKind::null ? "null" : "osmesa";
                         });

TEST(Application, RunsAScriptAndWritesItsPictures) {
  if (!openHost(SurfaceKind::osmesa, 64, 64)) GTEST_SKIP() << "install libosmesa6";
  test::TemporaryFolder folder;
  test::writeText(folder / "a.script", "run-to 30\nshot window\nshot image.png Image\n");
  InspectorOptions options;
  options.runner = std::make_unique<FakeRunner>();
  options.surface = SurfaceKind::osmesa;
  options.width = 640;
  options.height = 400;
  const auto script = [&] { return readScript(folder / "a.script").value(); };
  options.script = script();
  options.out = folder / "out";
  EXPECT_EQ(runInspector(options), 0);
  EXPECT_EQ(cv::imread((folder / "out/window.png").string()).size(), cv::Size(640, 400));
  EXPECT_FALSE(cv::imread((folder / "out/image.png").string()).empty());
  test::writeText(folder / "a.script", "expect frame == 3\n");
  options.script = script();
  EXPECT_EQ(runInspector(options), 1);
}

TEST(Application, NeedsAScriptWithoutAWindow) {
  InspectorOptions options;
  options.runner = std::make_unique<FakeRunner>();
  options.surface = SurfaceKind::null;
  EXPECT_EQ(runInspector(options), 2);
  options.exit_after_frames = 3;
  EXPECT_EQ(runInspector(options), 0);
}

}  // namespace
}  // namespace svoscope::ui
