// SPDX-License-Identifier: MIT
#include "ui/layout.h"

#include <gtest/gtest.h>

#include "ui/panels/panel.h"

namespace svoscope::ui {
namespace {

TEST(Layout, TextRoundTrip) {
  for (const std::string& name : presetNames()) {
    Layout layout = presetLayout(name);
    EXPECT_EQ(layout.name, name);
    const auto again = parseLayout(layoutText(layout));
    ASSERT_TRUE(again.ok()) << name;
    EXPECT_EQ(layoutText(again.value()), layoutText(layout));
  }
}

TEST(Layout, KeepsActiveTabAndRatio) {
  Layout layout = presetLayout("Tracking");
  layout.root.ratio = 0.25f;
  ASSERT_TRUE(raisePanel(layout.root, "Log"));
  const auto again = parseLayout(layoutText(layout));
  ASSERT_TRUE(again.ok());
  EXPECT_FLOAT_EQ(again.value().root.ratio, 0.25f);
  EXPECT_NE(layoutText(again.value()).find("*Log"), std::string::npos);
}

TEST(Layout, HideAndShow) {
  Layout layout = presetLayout("Tracking");
  hidePanel(layout.root, "3-D");
  EXPECT_FALSE(hasPanel(layout.root, "3-D"));
  EXPECT_TRUE(hasPanel(layout.root, "Funnel")) << "its neighbour takes the room";
  showPanel(layout.root, "3-D");
  EXPECT_TRUE(hasPanel(layout.root, "3-D"));
}

TEST(Layout, CopiesAreIndependent) {
  const Layout layout = presetLayout("Tracking");
  Layout copy = layout;
  hidePanel(copy.root, "Image");
  EXPECT_TRUE(hasPanel(layout.root, "Image"));
}

TEST(Layout, HidingEverythingLeavesAnEmptyLeaf) {
  Layout layout = presetLayout("Evaluation");
  for (const Panel* panel : panels()) hidePanel(layout.root, panel->name);
  EXPECT_TRUE(layout.root.leaf);
  EXPECT_TRUE(layout.root.panels.empty());
  const auto again = parseLayout(layoutText(layout));
  EXPECT_FALSE(again.ok()) << "an empty layout is not worth restoring";
}

TEST(Layout, ErrorsSayWhatIsWrong) {
  const auto unknown = parseLayout("Mine|[Image,Teapot]");
  ASSERT_FALSE(unknown.ok());
  EXPECT_NE(unknown.error().what.find("Teapot"), std::string::npos);
  EXPECT_FALSE(parseLayout("").ok());
  EXPECT_FALSE(parseLayout("Mine|h 0.5 ( [Image]").ok());
  EXPECT_FALSE(parseLayout("Mine|h 7 ( [Image] [Plots] )").ok());
  EXPECT_FALSE(parseLayout("Mine|[Image] [Plots]").ok());
}

}  // namespace
}  // namespace svoscope::ui
