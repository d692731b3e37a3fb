// SPDX-License-Identifier: MIT
#include "ui/harness/inspector_target.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ui/harness/tiny_runner.h"
#include "ui/harness/engine_driver.h"
#include "ui/panels/panel.h"

namespace svoscope::ui {
namespace {

using testing::HasSubstr;

class InspectorTargetTest : public testing::Test {
 protected:
  TinyRunner runner;
  UiState state;
  InspectorTarget target{runner, state};
};

TEST_F(InspectorTargetTest, ViewsProcessedFramesOnly) {
  ASSERT_TRUE(stepFrames(runner, 6).ok());
  EXPECT_TRUE(target.showFrame(2).ok());
  EXPECT_EQ(target.shownFrame(), 2);
  EXPECT_TRUE(target.showFrame(5).ok());
  EXPECT_EQ(target.shownFrame(), -1) << "the newest frame means live";
  EXPECT_THAT(target.showFrame(9).error().message(), HasSubstr("run-to 9"));
}

TEST_F(InspectorTargetTest, PanelsAndLayoutsByName) {
  EXPECT_TRUE(target.setLayout(presetNames().back()).ok());
  EXPECT_TRUE(target.showPanel(panels().front()->name).ok());
  EXPECT_EQ(state.maximized, panels().front()->name);
  EXPECT_TRUE(hasPanel(state.layout.root, panels().front()->name));
  EXPECT_TRUE(target.showPanel("all").ok());
  EXPECT_EQ(state.maximized, "");
  EXPECT_THAT(target.showPanel("Nonsense").error().message(), HasSubstr(panels().front()->name));
  EXPECT_THAT(target.setLayout("Nonsense").error().message(), HasSubstr(presetNames().front()));
}

TEST_F(InspectorTargetTest, OptionsAreSetAndReadByName) {
  EXPECT_TRUE(target.set("image.trails", "off").ok());
  EXPECT_FALSE(state.image.trails);
  EXPECT_TRUE(target.set("scene.yaw", "1.25").ok());
  EXPECT_EQ(std::get<double>(*target.value("scene.yaw")), 1.25);
  EXPECT_THAT(target.set("image.nonsense", "1").error().message(), HasSubstr("image.level"));
  EXPECT_FALSE(target.set("image.level", "high").ok());
}

TEST_F(InspectorTargetTest, SelectionNeedsWhatIsThere) {
  EXPECT_FALSE(target.selectFeature(3).ok());
  ASSERT_TRUE(stepFrames(runner, 1).ok());
  EXPECT_THAT(target.selectFeature(3).error().message(), HasSubstr("frame 0 has no feature 3"));
  EXPECT_EQ(std::get<double>(*target.value("selected.id")), -1);
  EXPECT_EQ(std::get<std::string>(*target.value("selected.kind")), "none");
}

}  // namespace
}  // namespace svoscope::ui
