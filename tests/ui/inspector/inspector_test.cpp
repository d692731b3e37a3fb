// SPDX-License-Identifier: MIT
#include "ui/inspector.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "tests/ui/inspector/inspector_fixture.h"
#include "ui/panels/panel.h"
#include "ui/panels/run/run_options.h"
#include "ui/panels/scene/image_overlay.h"
#include "ui/panels/scene/scene_content.h"
#include "ui/widgets/controls.h"

namespace svoscope::ui {
namespace {

using Kind = Command::Kind;

TEST_F(InspectorTest, TextWrapsAtBlanksOnly) {
  open();
  frames(1);
  EXPECT_EQ(wrapped("JS 0.4427 nats", 1), "JS\n0.4427\nnats");
  EXPECT_EQ(wrapped("JS 0.4427 nats", 1e6f), "JS 0.4427 nats");
  EXPECT_EQ(wrapped("", 1), "");
}

TEST_F(InspectorTest, TransportSendsCommands) {
  open();
  click("Play");
  EXPECT_TRUE(sent(Kind::play));
  click("Pause");
  EXPECT_TRUE(sent(Kind::pause));
  click("Step");
  EXPECT_TRUE(sent(Kind::step));
  click("Keyframe");
  EXPECT_TRUE(sent(Kind::run_to_keyframe));
  click("Loss");
  EXPECT_TRUE(sent(Kind::run_to_loss));
  click("Start");
  EXPECT_TRUE(sent(Kind::run_to_start));
  click("Frame");
  ASSERT_TRUE(sent(Kind::run_to_frame));
  EXPECT_EQ(runner_->sent().back().frame, 100);
}

TEST_F(InspectorTest, NothingToGoBackToBeforeTheFirstFrame) {
  open();
  click("Back");
  EXPECT_EQ(state().viewed_frame, -1);
  EXPECT_TRUE(runner_->sent().empty());
}

TEST_F(InspectorTest, SteppingBackShowsAnOlderFrameAndSaysSo) {
  open();
  runner_->runTo(60);
  frames(2);
  EXPECT_FALSE(Probe::find("Back to live"));
  click("Back");
  EXPECT_EQ(state().viewed_frame, 58);
  EXPECT_TRUE(Probe::find("viewing older frame"));
  EXPECT_TRUE(runner_->sent().empty()) << "the engine stays where it is";
  click("Step");
  EXPECT_EQ(state().viewed_frame, -1) << "the newest frame is live";
  press(Key::left);
  press(Key::left);
  EXPECT_EQ(state().viewed_frame, 57);
  click("Back to live");
  EXPECT_EQ(state().viewed_frame, -1);
}

TEST_F(InspectorTest, StepBackEndsAtTheOldestFrameHeld) {
  FakeOptions options;
  options.history = 5;
  open(options);
  runner_->runTo(60);
  frames();
  press(Key::home);
  EXPECT_EQ(state().viewed_frame, 55);
  press(Key::left);
  EXPECT_EQ(state().viewed_frame, 55);
  ASSERT_FALSE(state().toasts.list().empty());
}

TEST_F(InspectorTest, ClickOnTheTimelineScrubs) {
  open();
  runner_->runTo(200);
  frames(2);
  const auto strip = Probe::find("Timeline");
  ASSERT_TRUE(strip);
  const float x = strip->min.x + (100.5f / 240) * strip->size().x;
  clickAt({x, strip->center().y});
  EXPECT_EQ(state().viewed_frame, 100);
  clickAt({strip->max.x - 2, strip->center().y});
  EXPECT_EQ(state().viewed_frame, -1) << "beyond the engine is live";
}

TEST_F(InspectorTest, ClickInTheImageSelectsTheFeatureAtAnyZoom) {
  FakeOptions options;
  options.seeds = 0;
  open(options);
  runner_->runTo(60);
  const Snapshot& s = *runner_->latest();
  const FeatureView* target = nullptr;
  for (const FeatureView& f : s.features) {
    const bool central = std::abs(f.px.x() - 320) < 200 && std::abs(f.px.y() - 240) < 140;
    if (central && f.type == FeatureType::corner && shows(state().image, f)) target = &f;
  }
  ASSERT_TRUE(target);
  for (const float zoom : {0.0f, 1.5f, 4.0f, 20.0f}) {
    state().selection = {};
    state().image.view.zoom = zoom;
    state().image.view.center = target->px + Px(3, -2);
    frames(2);
    const auto area = Probe::find("image:view");
    ASSERT_TRUE(area);
    ImageView view;
    view.lo = area->min;
    view.hi = area->max;
    view.zoom = zoom > 0 ? zoom : state().image_fit;
    view.center = zoom > 0 ? state().image.view.center : Px(319.5f, 239.5f);
    clickAt(view.toScreen(target->px));
    EXPECT_EQ(state().selection, selectionOf(*target)) << "zoom " << zoom;
  }
}

TEST_F(InspectorTest, SelectionShowsFactsAndEscapeClears) {
  open();
  runner_->runTo(80);
  state().selection = {Selection::Kind::seed, 1063};
  raisePanel(state().layout.root, "Selection");
  frames(3);
  EXPECT_TRUE(Probe::find("Clear"));
  press(Key::escape);
  EXPECT_FALSE(state().selection);
}

TEST_F(InspectorTest, ShortcutsDoNotFireWhileTyping) {
  open();
  runner_->runTo(30);
  raisePanel(state().layout.root, "Log");
  frames(2);
  click("log_filter");
  host_->scriptInput().text = "lost";
  press(keyOf('L'));
  press(Key::space);
  EXPECT_EQ(state().options.get<LogOptions>().filter, "lost");
  EXPECT_TRUE(runner_->sent().empty());
  press(Key::escape);
  press(keyOf('L'));
  EXPECT_TRUE(sent(Kind::run_to_loss));
}

TEST_F(InspectorTest, ShortcutsDriveTheMainLoop) {
  open();
  press(Key::right);
  EXPECT_TRUE(sent(Kind::step));
  press(Key::right, true);
  EXPECT_TRUE(sent(Kind::run_to_keyframe));
  press(Key::space);
  EXPECT_EQ(runner_->sent().back().kind, Kind::pause) << "it was running to a keyframe";
  press(keyOf('3'));
  EXPECT_EQ(state().layout.name, "KL / JS");
  press(keyOf('4'));
  EXPECT_EQ(state().layout.name, "Evaluation");
  press(Key::slash, true);
  EXPECT_TRUE(state().show_help);
  press(Key::escape);
  EXPECT_FALSE(state().show_help);
  press(keyOf('P'));
  const auto name = inspector_->takeScreenshotRequest();
  ASSERT_TRUE(name);
  EXPECT_NE(name->find("synthetic-fake_it-svo_frame00000.png"), std::string::npos);
  EXPECT_FALSE(inspector_->takeScreenshotRequest());
}

TEST_F(InspectorTest, DoubleClickOnATitleMaximises) {
  open();
  const auto title = Probe::find("tab:3-D");
  ASSERT_TRUE(title);
  InputState& input = host_->scriptInput();
  input.mouse = title->center();
  for (int i = 0; i < 2; ++i) {
    input.setButton(0, true);
    frames();
    input.setButton(0, false);
    frames();
  }
  EXPECT_EQ(state().maximized, "3-D");
  EXPECT_FALSE(Probe::find("panel:Image"));
}

TEST_F(InspectorTest, ResetForgetsSelectionAndView) {
  open();
  runner_->runTo(60);
  frames();
  state().selection = {Selection::Kind::landmark, 1002};
  state().viewed_frame = 30;
  frames();
  click("Reset");
  EXPECT_FALSE(state().selection);
  EXPECT_EQ(state().viewed_frame, -1);
  EXPECT_TRUE(inspector_->caches().run.records().empty());
}

TEST_F(InspectorTest, ParametersAreEditedAndPutBack) {
  open();
  state().maximized = "Parameters";
  frames(2);
  click("Default reproject.cell_px");
  ASSERT_TRUE(sent(Kind::set_parameter));
  EXPECT_EQ(runner_->sent().back().value, "25");
  click("seeds.edgelets");
  EXPECT_EQ(runner_->sent().back().key, "seeds.edgelets");
  EXPECT_EQ(runner_->sent().back().value, "false");
}

TEST_F(InspectorTest, SceneIsRebuiltOnlyWhenItChanges) {
  open();
  runner_->runTo(60);
  frames(3);
  const SceneContent& content = inspector_->caches().own.get<SceneContent>();
  const auto version = content.scene().version;
  frames(5);
  EXPECT_EQ(content.scene().version, version);
  runner_->runTo(61);
  frames();
  EXPECT_GT(content.scene().version, version);
}

TEST_F(InspectorTest, FirstViewShowsTheMap) {
  open();
  runner_->runTo(120);
  frames(3);
  const SceneOptions& o = state().scene;
  const SceneContent& content = inspector_->caches().own.get<SceneContent>();
  EXPECT_LT((o.target - content.center()).norm(), 1e-9);
  EXPECT_GT(o.distance, content.radius());
  EXPECT_LT(o.distance, content.radius() * 5);
}

// Every panel in every size and state: no assertion of ImGui fails, nothing divides by zero.
TEST_F(InspectorTest, SurvivesEmptyAndOddSituations) {
  FakeOptions no_features;
  no_features.features = false;
  no_features.ground_truth = false;
  for (const FakeOptions& options : {FakeOptions(), no_features}) {
    open(options, 320, 240, 2);
    for (const int frames_done : {0, 1, 14, 145}) {
      runner_->runTo(frames_done);
      for (const SurfaceSize size :
           {SurfaceSize{320, 240}, SurfaceSize{1, 1}, SurfaceSize{900, 500}}) {
        host_->resize(size);
        for (const Panel* panel : panels()) {
          state().maximized = panel->name;
          frames();
        }
        state().maximized.clear();
        frames(2);
      }
    }
  }
}

TEST_F(InspectorTest, AnEvictedFrameIsExplained) {
  FakeOptions options;
  options.history = 5;
  open(options);
  runner_->runTo(60);
  state().viewed_frame = 10;
  for (const Panel* panel : panels()) {
    state().maximized = panel->name;
    frames();
  }
  EXPECT_EQ(state().viewed_frame, 10);
}

TEST_F(InspectorTest, LayoutIsSavedAndRestored) {
  const std::string path = ::testing::TempDir() + "svoscope_layout/layout.txt";
  std::filesystem::remove(path);
  open();
  inspector_->useLayoutFile(path);
  press(keyOf('2'));
  ASSERT_TRUE(std::filesystem::exists(path));
  Inspector other(*runner_, host_->graphics());
  other.useLayoutFile(path);
  EXPECT_EQ(other.state().layout.name, "Seeds");
  std::ofstream(path) << "nonsense\n";
  Inspector third(*runner_, host_->graphics());
  third.useLayoutFile(path);
  EXPECT_EQ(third.state().layout.name, "Tracking");
  EXPECT_FALSE(third.state().toasts.list().empty());
}

}  // namespace
}  // namespace svoscope::ui
