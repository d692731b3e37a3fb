// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <map>
#include <set>

#include "ui/harness/inspector_options.h"
#include "ui/panels/panel.h"

namespace svoscope::ui {
namespace {

TEST(PanelList, NamesAreUniqueAndFound) {
  std::set<std::string> names;
  for (const Panel* panel : panels()) {
    EXPECT_TRUE(names.insert(panel->name).second) << panel->name;
    EXPECT_EQ(findPanel(panel->name), panel);
    EXPECT_TRUE(panel->draw) << panel->name;
    // A panel whose menu offers nothing but a picture of texts needs no button, never the reverse.
    if (!panel->csv && !panel->charts) continue;
    EXPECT_TRUE(panel->exportable) << panel->name;
  }
  EXPECT_EQ(findPanel("Teapot"), nullptr);
}

// Layout files are one line with panels between [ , ] and an asterisk for the active one.
TEST(PanelList, NamesCanStandInALayout) {
  for (const Panel* panel : panels()) {
    const std::string name = panel->name;
    EXPECT_EQ(name.find_first_of("[],*|"), std::string::npos) << name;
    const auto layout = parseLayout("Mine|[*" + name + ",Image]");
    EXPECT_TRUE(layout.ok()) << name;
  }
}

TEST(PanelList, OptionsAreReadBackAsSet) {
  for (const Panel* panel : panels()) {
    if (!panel->options) continue;
    for (const PanelOption& option : panel->options()) {
      UiState state;
      const double before = option.get(state);
      option.set(state, before == 0 ? 1 : 0);
      EXPECT_NE(option.get(state), before) << option.name;
      EXPECT_TRUE(setOption(state, option.name, before == 0 ? "0" : "1").ok()) << option.name;
      EXPECT_EQ(option.get(state), before == 0 ? 0 : 1) << option.name;
    }
  }
}

struct Own {
  int value = 7;
};

TEST(TypedStore, KeepsOneValueOfEachType) {
  TypedStore store;
  const TypedStore& reader = store;
  EXPECT_EQ(reader.get<Own>().value, 7) << "a default before anybody made one";
  Own& own = store.get<Own>();
  own.value = 8;
  store.get<std::map<int, int>>()[3] = 4;
  EXPECT_EQ(reader.get<Own>().value, 8);
  TypedStore moved = std::move(store);
  EXPECT_EQ(&moved.get<Own>(), &own) << "references outlive a move";
  EXPECT_EQ((TypedStore().get<Own>().value), 7);
}

}  // namespace
}  // namespace svoscope::ui
