// SPDX-License-Identifier: MIT
// The seed panels: what they show equals the snapshot, stepping, pinning, empty states.
#include <algorithm>

#include "tests/ui/panels/seed/seed_panels_fixture.h"
#include "ui/model/seed_trace.h"
#include "ui/panels/seed/seed_charts.h"
#include "ui/widgets/controls.h"

namespace svoscope::ui {
namespace {

TEST_F(SeedPanels, ShowTheNumbersOfTheSnapshot) {
  openAt(60, "Seed");
  ASSERT_TRUE(Probe::find("Belief density"));
  const SeedTrace* trace = inspector_->caches().own.get<SeedTraces>().find(update_.seed_id);
  ASSERT_TRUE(trace);
  EXPECT_EQ(state().seed.held_updates, static_cast<int>(trace->updates.size()));
  EXPECT_EQ(state().seed.shown_update, state().seed.held_updates) << "live: the newest update";
  const SeedUpdateView& shown = trace->updates.back();
  const SeedView& seed = *findSeed(*runner_->latest(), update_.seed_id);
  EXPECT_EQ(shown.after[FilterRule::kl].mu, seed.belief[FilterRule::kl].mu);
  EXPECT_EQ(shown.after[FilterRule::js].sigma, seed.belief[FilterRule::js].sigma);
  const auto facts = seedFacts(shown, 0);
  ASSERT_GE(facts.size(), 5u);
  EXPECT_EQ(facts[0].text[FilterRule::kl],
            format("%.5f → %.5f", shown.before[FilterRule::kl].mu, seed.belief[FilterRule::kl].mu));
  EXPECT_EQ(facts[1].text[FilterRule::js], format("%.5f → %.5f", shown.before[FilterRule::js].sigma,
                                                  seed.belief[FilterRule::js].sigma));
  EXPECT_EQ(facts[4].text[FilterRule::kl],
            format("%.3f → %.3f", inlierRatio(shown.before[FilterRule::kl]),
                   seed.belief[FilterRule::kl].a /
                       (seed.belief[FilterRule::kl].a + seed.belief[FilterRule::kl].b)));
}

TEST_F(SeedPanels, StepThroughUpdatesByButtonKeyAndChart) {
  openAt(60, "Seed");
  const int held = state().seed.held_updates;
  ASSERT_GT(held, 5);
  click("Previous update");
  EXPECT_EQ(state().seed.shown_update, held - 1);
  EXPECT_EQ(state().viewed_frame, 58) << "the image follows";
  press(Key::comma);
  EXPECT_EQ(state().seed.shown_update, held - 2);
  press(Key::period);
  press(Key::period);
  EXPECT_EQ(state().seed.shown_update, held);
  EXPECT_EQ(state().viewed_frame, -1);
  click("First update");
  EXPECT_EQ(state().seed.shown_update, 1);
  press(Key::comma);
  EXPECT_EQ(state().seed.shown_update, 1) << "nothing before the first";
  press(Key::right);
  EXPECT_EQ(state().seed.shown_update, 2) << "another frame frees the choice";
}

TEST_F(SeedPanels, ImageStaysWhereItIsIfToldSo) {
  openAt(60, "Seed");
  state().seed.image_follows = false;
  const int held = state().seed.held_updates;
  click("Previous update");
  EXPECT_EQ(state().seed.shown_update, held - 1);
  EXPECT_EQ(state().viewed_frame, -1);
}

TEST_F(SeedPanels, PinnedSeedsStayAndCanBeSelected) {
  openAt(60, "Seed");
  click("Pin");
  ASSERT_EQ(state().seed.pinned.size(), 1u);
  const std::int64_t pinned = state().seed.pinned.front();
  state().selection = {Selection::Kind::seed, runner_->latest()->seeds->front().id};
  frames(3);
  EXPECT_TRUE(inspector_->caches().own.get<SeedTraces>().find(pinned));
  state().selection = {Selection::Kind::seed, pinned};
  frames(3);
  click("Unpin");
  EXPECT_TRUE(state().seed.pinned.empty());
}

TEST_F(SeedPanels, ExportsEveryUpdate) {
  openAt(60, "Seed");
  const SeedTrace* trace = inspector_->caches().own.get<SeedTraces>().find(update_.seed_id);
  const std::string csv = traceCsv(*trace);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), static_cast<long>(trace->updates.size()) + 1);
}

TEST_F(SeedPanels, SayWhyTheyAreEmpty) {
  for (const char* panel : {"Seed", "Epipolar search", "KL / JS", "Filter lab"}) {
    open();
    maximize(panel);
    frames(2);
    EXPECT_FALSE(Probe::find("Belief density")) << panel;
    runner_->runTo(3);
    frames(3);
    FakeOptions none;
    none.features = false;
    open(none);
    runner_->runTo(60);
    state().selection = {Selection::Kind::seed, 123456};
    maximize(panel);
    frames(3);
  }
}

TEST_F(SeedPanels, OfferASeed) {
  open();
  runner_->runTo(60);
  maximize("Seed");
  frames(2);
  click("Select a seed");
  EXPECT_EQ(state().selection.kind, Selection::Kind::seed);
  EXPECT_TRUE(Probe::find("Belief density"));
}

}  // namespace
}  // namespace svoscope::ui
