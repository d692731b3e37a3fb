// SPDX-License-Identifier: MIT
// Seeds that have run out of numbers: nothing is drawn or written that is none.
#include <cmath>
#include <limits>

#include "tests/support/scripted_runner.h"
#include "tests/ui/panels/seed/seed_panels_fixture.h"
#include "ui/model/seed_trace.h"
#include "ui/panels/seed/densities.h"
#include "ui/panels/seed/seed_charts.h"

namespace svoscope::ui {
namespace {

TEST(Densities, DegenerateParametersGiveNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               inf = std::numeric_limits<double>::infinity();
  for (const double sigma : {0.0, -1.0, nan, inf}) {
    EXPECT_TRUE(gaussianCurve(1, sigma, {0, 2}).x.empty());
    EXPECT_TRUE(gaussianAsDistance(1, sigma, {0.5, 2}).x.empty());
  }
  EXPECT_TRUE(gaussianCurve(nan, 1, {0, 2}).x.empty());
  EXPECT_TRUE(betaCurve(0, 1).x.empty());
  EXPECT_TRUE(betaCurve(nan, 1).x.empty());
  for (const float y : betaCurve(1e7, 1e7).y) EXPECT_TRUE(std::isfinite(y));
  EXPECT_GT(betaCurve(1e7, 1e7).peak(), 1000) << "the peak is not missed";
  EXPECT_NEAR(gaussianCurve(1, 1e-6, {0, 2}).peak(), 1e6 / std::sqrt(2 * M_PI), 4e5);
}

// Every vertex that would be drawn is a number.
bool allFinite(const ImDrawData* data) {
  if (!data) return true;
  for (int i = 0; i < data->CmdListsCount; ++i) {
    for (const ImDrawVert& v : data->CmdLists[i]->VtxBuffer) {
      if (!std::isfinite(v.pos.x) || !std::isfinite(v.pos.y)) return false;
    }
  }
  return true;
}

SeedUpdateView badUpdate(const BeliefView& bad) {
  SeedUpdateView u;
  u.seed_id = 7;
  u.frame_index = 2;
  u.outcome = SearchOutcome::matched;
  u.before.fill(bad);
  u.after.fill(bad);
  u.x = bad.mu;
  u.tau = bad.sigma;
  u.kl_belief_measurement = std::numeric_limits<float>::infinity();
  u.jsd = std::numeric_limits<float>::quiet_NaN();
  return u;
}

std::vector<BeliefView> badBeliefs() {
  const float nan = std::numeric_limits<float>::quiet_NaN(),
              inf = std::numeric_limits<float>::infinity();
  return {{1, 0, 10, 10},
          {nan, nan, nan, nan},
          {inf, inf, 1e30f, 1e30f},
          {-1, 1e-30f, 0, 0},
          {0, 1e30f, 1e8f, 1}};
}

class DegenerateSeeds : public SeedPanels {};

// Snapshots with seeds that have run out of numbers.
TEST_F(DegenerateSeeds, DrawNothingWrongInAnyPanel) {
  open();
  for (const BeliefView& bad : badBeliefs()) {
    for (const float range : {0.0f, 1.0f, std::numeric_limits<float>::quiet_NaN()}) {
      test::ScriptedRunner runner(test::fakeRecords(3));
      auto snapshot = std::make_shared<Snapshot>(*test::fakeSnapshot(test::fakeRecords(3)[2]));
      SeedView seed;
      seed.id = 7;
      seed.range = range;
      seed.belief.fill(bad);
      seed.mu = bad.mu, seed.sigma = bad.sigma, seed.a = bad.a, seed.b = bad.b;
      seed.visible = true;
      seed.updates = 2;
      seed.true_inv_distance = 0.5f;
      snapshot->seeds = std::make_shared<const std::vector<SeedView>>(3, seed);
      snapshot->seed_updates =
          std::make_shared<const std::vector<SeedUpdateView>>(3, badUpdate(bad));
      runner.last_ = snapshot;
      Command play;
      play.kind = Command::Kind::play;
      runner.send(play);
      while (runner.pump()) {
      }
      Inspector inspector(runner, host_->graphics());
      inspector.state().selection = {Selection::Kind::seed, 7};
      inspector.state().seed.pinned = {7};
      inspector.state().image.seed_color = SeedColorBy::disagreement;
      for (const char* panel :
           {"Seed", "Epipolar search", "KL / JS", "3-D", "Image", "Selection"}) {
        if (!hasPanel(inspector.state().layout.root, panel))
          showPanel(inspector.state().layout.root, panel);
        inspector.state().maximized = panel;
        for (const bool distance : {false, true}) {
          inspector.state().seed.distance = distance;
          for (int i = 0; i < 2; ++i) host_->frame(inspector, false);
          EXPECT_TRUE(allFinite(ImGui::GetDrawData())) << panel;
        }
      }
    }
  }
}

TEST_F(DegenerateSeeds, SayNoNaN) {
  for (const BeliefView& bad : badBeliefs()) {
    const SeedUpdateView u = badUpdate(bad);
    SeedTrace trace;
    trace.id = 7;
    trace.updates = {u, u};
    trace.published = {1, 2};
    const TraceColumns columns = traceColumns(trace);
    EXPECT_EQ(columns.step.size(), 2u);
    for (const SeedFact& f : seedFacts(u, 0.5))
      for (const std::string& text : f.text)
        EXPECT_EQ(text.find("nan"), std::string::npos) << f.name << ": " << text;
  }
}

}  // namespace
}  // namespace svoscope::ui
