// SPDX-License-Identifier: MIT
#include "ui/harness/executor.h"

#include <gmock/gmock.h>

#include <opencv2/imgcodecs.hpp>

#include "tests/support/support.h"
#include "tests/ui/harness/fake_runner.h"
#include "tests/ui/render/render_fixture.h"

namespace svoscope::ui {
namespace {

using testing::HasSubstr;

/// A window with one of each widget, each recorded for the probe.
struct DemoContent : UiContent {
  bool on = false;
  int clicks = 0, doubles = 0, rights = 0, spaces = 0;
  float value = 0.5f;
  float wheel = 0;
  char text[64] = "";
  void draw() override {
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({300, 200});
    ImGui::Begin("##demo", nullptr, ImGuiWindowFlags_NoDecoration);
    if (ImGui::Button(on ? "Pause###play" : "Play###play")) on = !on, ++clicks;
    Probe::record("Play");
    if (ImGui::IsItemHovered()) {
      doubles += ImGui::IsMouseDoubleClicked(0);
      rights += ImGui::IsMouseReleased(1);
      wheel += ImGui::GetIO().MouseWheel;
    }
    ImGui::SliderFloat("Gain", &value, 0, 1);
    Probe::record("Gain");
    ImGui::InputText("##name", text, sizeof text);
    Probe::record("##name");
    if (!ImGui::GetIO().WantTextInput)
      spaces += ImGui::IsKeyPressed(index(Key::space), false);
    const ImVec2 lo(20, 120), hi(120, 180);
    ImGui::GetWindowDrawList()->AddRectFilled(lo, hi, IM_COL32(0, 200, 0, 255));
    Probe::record("panel:Green", lo, hi);
    ImGui::End();
  }
};

class ExecutorTest : public testing::Test {
 protected:
  std::string run(const std::string& text) {
    if (!host) host = openHost(SurfaceKind::null, 320, 240);
    const Result<Script> script = parseScript(text, "test.script");
    if (!script) return script.error().message();
    const Result<ScriptReport> result =
        runScript(script.value(), {*host, content, target, &runner, folder.path()});
    if (!result) return result.error().message();
    report = result.value();
    return "";
  }
  test::TemporaryFolder folder;
  std::unique_ptr<Host> host;
  DemoContent content;
  ScriptTarget target;
  FakeRunner runner;
  ScriptReport report;
};

TEST_F(ExecutorTest, ClicksAreFramesWithTheButtonDownAndUp) {
  EXPECT_EQ(run("click Play\n"), "");
  EXPECT_TRUE(content.on);
  EXPECT_EQ(run("click Play\nclick Play\n"), "");
  EXPECT_EQ(content.clicks, 3);
  EXPECT_EQ(content.doubles, 0) << "clicks in a row must not count as a double click";
  EXPECT_EQ(run("double-click Play\nright-click Play\n"), "");
  EXPECT_EQ(content.doubles, 1);
  EXPECT_EQ(content.rights, 1);
  EXPECT_EQ(run("wheel Play -2\n"), "");
  EXPECT_EQ(content.wheel, -2);
}

TEST_F(ExecutorTest, UnknownLabelsNameTheOnesThatAreThere) {
  const std::string message = run("\nclick Stop\n");
  EXPECT_THAT(message, HasSubstr("test.script:2"));
  EXPECT_THAT(message, HasSubstr("\"Play\""));
}

TEST_F(ExecutorTest, KeysReachShortcutsUnlessTextIsTyped) {
  EXPECT_EQ(run("key space\nkey space\n"), "");
  EXPECT_EQ(content.spaces, 2);
  EXPECT_EQ(run("click ##name\ntype \"a σ\"\nkey b\nkey space\nkey shift+c\nkey enter\n"), "");
  EXPECT_STREQ(content.text, "a σb C");
  EXPECT_EQ(content.spaces, 2);
  EXPECT_THAT(run("key hyper\n"), HasSubstr("pageup"));
}

TEST_F(ExecutorTest, DragsMoveSliders) {
  EXPECT_EQ(run("drag Gain 60 0\n"), "");
  EXPECT_GT(content.value, 0.7f);
}

TEST_F(ExecutorTest, DrivesTheEngine) {
  EXPECT_EQ(run("step 3\nexpect frame == 2\nexpect state == initializing\n"), "");
  EXPECT_EQ(run("run-to start\nexpect frame == 5\nrun-to keyframe\nexpect frame == 10\n"
                "expect is_keyframe == true\nrun-to 12\nexpect frame == 12\n"),
            "");
  EXPECT_THAT(run("expect inliers > 500\n"), HasSubstr("it is 112"));
  EXPECT_THAT(run("run-to lost\n"), HasSubstr("ended after frame 19 (tracking"));
  EXPECT_THAT(run("step\n"), HasSubstr("ended"));
  EXPECT_EQ(run("reset\nstep\nexpect frame == 0\n"), "");
  EXPECT_EQ(run("set track.gain 2\n"), "");
  EXPECT_EQ(runner.last_set, "track.gain=2");
  EXPECT_THAT(run("set no.such 2\n"), HasSubstr("no.such"));
  EXPECT_THAT(run("expect nonsense == 1\n"), HasSubstr("reprojection_px"));
}

TEST_F(ExecutorTest, SizesScalesAndLabelsCanBeExpected) {
  EXPECT_EQ(run("size 640x480\nexpect width == 640\nscale 2\nexpect labels has Play\n"), "");
  EXPECT_EQ(ImGui::GetIO().DisplaySize.y, 480);
  EXPECT_THAT(run("size 12\n"), HasSubstr("1280x800"));
  EXPECT_THAT(run("scale 9\n"), HasSubstr("0.25 to 4"));
}

TEST_F(ExecutorTest, ShotsWithoutPixelsAreLeftOutWithANote) {
  EXPECT_EQ(run("shot a.png\n"), "");
  EXPECT_TRUE(report.pictures.empty());
  ASSERT_EQ(report.notes.size(), 1u);
  EXPECT_THAT(report.notes[0], HasSubstr("null surface"));
}

TEST_F(ExecutorTest, ShotsWriteTheWindowOrOnePanel) {
  host = openHost(SurfaceKind::osmesa, 320, 240);
  if (!host) GTEST_SKIP() << "OSMesa is absent: install libosmesa6";
  EXPECT_EQ(run("shot sub/all\nshot green.png Green\n"), "");
  EXPECT_EQ(cv::imread((folder / "sub/all.png").string()).size(), cv::Size(320, 240));
  const cv::Mat green = cv::imread((folder / "green.png").string());
  ASSERT_EQ(green.size(), cv::Size(100, 60));
  EXPECT_EQ(green.at<cv::Vec3b>(30, 50), cv::Vec3b(0, 200, 0));
  EXPECT_THAT(run("shot red.png Red\n"), HasSubstr("panel:Red"));
}

}  // namespace
}  // namespace svoscope::ui
