// SPDX-License-Identifier: MIT
// What panels say: only what was measured, on axes that belong together, and nothing cut unseen.
#include <cmath>

#include "engine/runner/lockstep_runner.h"
#include "tests/support/scripted_runner.h"
#include "tests/ui/drawn_text.h"
#include "tests/ui/inspector/inspector_fixture.h"
#include "ui/harness/inspector_target.h"
#include "ui/model/search_cache.h"
#include "ui/model/seed_trace.h"
#include "ui/panels/run/run_options.h"

namespace svoscope::ui {
namespace {

class PanelText : public InspectorTest {
 protected:
  void maximize(Inspector& inspector, const char* panel) {
    UiState& s = inspector.state();
    if (!hasPanel(s.layout.root, panel)) showPanel(s.layout.root, panel);
    raisePanel(s.layout.root, panel);
    s.maximized = panel;
  }
  std::vector<DrawnText> shown(Inspector& inspector, const char* panel) {
    maximize(inspector, panel);
    for (int i = 0; i < 3; ++i) host_->frame(inspector, false);
    return drawnTexts([&] { host_->frame(inspector, false); });
  }
  std::vector<DrawnText> shown(const char* panel) { return shown(*inspector_, panel); }
  static void finish(Runner& runner) {
    runner.send({Command::Kind::play, -1, "", ""});
    while (runner.pump()) {
    }
  }
};

TEST_F(PanelText, ALostFrameShowsNoMeasurementsItDoesNotHave) {
  open();
  auto rows = test::fakeRecords(11);  // the last one is lost
  rows.back().reason = "lost, no keyframe looks like this frame";
  for (FrameRecord& r : rows) {
    if (r.pose_good) r.funnel.required = 40, r.funnel.inliers = 100, r.funnel.aligned_sparse = 90;
  }
  test::ScriptedRunner runner(rows);
  runner.last_ = test::fakeSnapshot(rows.back());
  finish(runner);
  Inspector inspector(runner, host_->graphics());
  inspector.state().options.get<PlotsOptions>().groups = {"Features"};
  for (const DrawnText& t : shown(inspector, "Funnel")) {
    for (const char* made_up :
         {"0 inliers", "0.00 px", "0 patches", "gain 1.000", "0 landmarks, 0 seeds"}) {
      if (t.text == "0 landmarks, 0 seeds, 3 keyframes") continue;  // of the map: a count
      EXPECT_EQ(t.text.find(made_up), std::string::npos) << t.text;
    }
  }
  EXPECT_EQ(countOf(shown(inspector, "Funnel"), "–"), 6);
  EXPECT_EQ(countOf(shown(inspector, "Plots"), "lost below"), 1)
      << "the threshold outlives the loss";
}

TEST_F(PanelText, FramesThatWereMeasuredShowIt) {
  open();
  runner_->runTo(60);
  const auto texts = shown("Funnel");
  EXPECT_TRUE(anyHas(texts, "40 inliers"));
  EXPECT_TRUE(anyHas(texts, "px median"));
  EXPECT_EQ(countOf(texts, "–"), 0);
}

TEST_F(PanelText, TheTimingStripHasAFrameAxis) {
  open();
  runner_->runTo(120);
  const auto texts = shown("Timing");
  EXPECT_GE(countOf(texts, "100"), 1);
  EXPECT_GE(countOf(texts, "0"), 1);
}

// Seed 5 in every frame, tracked as a feature from frame 20 on.
class SeedHistoryRunner : public test::ScriptedRunner {
 public:
  SeedHistoryRunner() : ScriptedRunner(test::fakeRecords(40)) {
    for (const FrameRecord& record : test::fakeRecords(40)) {
      auto s = std::make_shared<Snapshot>(*test::fakeSnapshot(record));
      SeedView seed;
      seed.id = 5;
      s->seeds = std::make_shared<const std::vector<SeedView>>(1, seed);
      FeatureView feature;
      feature.id = 5;
      feature.origin = FeatureOrigin::unconverged_seed;
      feature.residual_px = 0.25f;
      if (record.index >= 20) s->features.push_back(feature);
      frames_.push_back(s);
    }
    last_ = frames_.back();
  }
  SnapshotPtr at(int frame) const override {
    return frame >= 0 && frame < 40 ? frames_[static_cast<std::size_t>(frame)] : nullptr;
  }

 private:
  std::vector<SnapshotPtr> frames_;
};

TEST_F(PanelText, HistoriesOfTheSelectionSpanTheSameFrames) {
  open({}, 1280, 1200);
  SeedHistoryRunner runner;
  finish(runner);
  Inspector inspector(runner, host_->graphics());
  host_->frame(inspector, false);
  inspector.state().selection = {Selection::Kind::seed, 5};
  const auto texts = shown(inspector, "Selection");
  ASSERT_TRUE(anyHas(texts, "Residual, px"));
  EXPECT_EQ(countOf(texts, "10"), 4) << "each of four plots begins before the feature";
  EXPECT_EQ(countOf(texts, "30"), 4);
}

TEST_F(PanelText, MessagesAreCountedAndCutVisibly) {
  open();
  test::ScriptedRunner runner(test::fakeRecords(5));
  runner.events_ = {{3, EventKind::warning, std::string(400, 'w')}};
  finish(runner);
  Inspector inspector(runner, host_->graphics());
  const auto texts = shown(inspector, "Log");
  EXPECT_TRUE(anyHas(texts, "www…"));
}

SeedView seedOf(std::int64_t id, FeatureType type, int updates) {
  SeedView s;
  s.id = id;
  s.type = type;
  s.updates = updates;
  s.visible = true;
  s.mu = 0.5f;
  s.sigma = 0.1f;
  s.belief.fill({s.mu, s.sigma});
  return s;
}

// One frame with a segment seed that has most updates, of which none is kept, and a corner.
class SegmentSeeds : public PanelText {
 protected:
  SegmentSeeds() : runner(test::fakeRecords(3)) {}
  void SetUp() override {
    open();
    auto snapshot = std::make_shared<Snapshot>(*test::fakeSnapshot(test::fakeRecords(3)[2]));
    std::vector<SeedView> seeds{seedOf(7, FeatureType::segment, 50),
                                seedOf(8, FeatureType::corner, 0),
                                seedOf(9, FeatureType::corner, 3)};
    seeds[0].outcome = SearchOutcome::matched;
    seeds[2].status = SeedStatus::converged;
    snapshot->seeds = std::make_shared<const std::vector<SeedView>>(seeds);
    SeedUpdateView update;
    update.seed_id = 9;
    update.frame_index = 2;
    update.outcome = SearchOutcome::matched;
    update.x = 0.5f;
    update.tau = 0.1f;
    update.before = update.after = seeds[2].belief;
    snapshot->seed_updates = std::make_shared<const std::vector<SeedUpdateView>>(1, update);
    runner.last_ = snapshot;
    finish(runner);
    inspector = std::make_unique<Inspector>(runner, host_->graphics());
    host_->frame(*inspector, false);  // a new run empties the selection
  }
  test::ScriptedRunner runner;
  std::unique_ptr<Inspector> inspector;
};

TEST_F(SegmentSeeds, AreNotWhatAnySeedMeans) {
  InspectorTarget target(runner, inspector->state());
  ASSERT_TRUE(target.selectSeed(-1).ok());
  EXPECT_EQ(inspector->state().selection.id, 9) << "the point seed whose updates are held";
  shown(*inspector, "Seed");
  EXPECT_TRUE(Probe::find("Belief density"));
}

TEST_F(SegmentSeeds, AreNotOfferedByTheButton) {
  shown(*inspector, "Seed");
  const auto rect = Probe::find("Select a seed");
  ASSERT_TRUE(rect);
  InputState& input = host_->scriptInput();
  input.mouse = rect->center();
  for (const bool down : {false, true, false}) {
    input.setButton(0, down);
    host_->frame(*inspector, false);
  }
  EXPECT_EQ(inspector->state().selection.id, 9);
}

TEST_F(SegmentSeeds, ShowNoChartsWithMadeUpAxes) {
  for (const std::int64_t id : {7, 8}) {
    inspector->state().selection = {Selection::Kind::seed, id};
    for (const char* panel : {"Seed", "Epipolar search"}) {
      shown(*inspector, panel);
      for (const char* chart :
           {"Belief density", "Belief history", "Sigma history", "Score profile", "update"}) {
        EXPECT_FALSE(Probe::find(chart)) << panel << ", " << chart;
      }
    }
  }
}

TEST(SearchText, TheBestSampleIsNotAcceptedWhereThereIsNoMatch) {
  SearchDetail d;
  d.profile.resize(3);
  for (SearchSample& s : d.profile) s.score = 900;
  d.best = 1;
  d.max_score = 2000;
  d.outcome = SearchOutcome::matched;
  EXPECT_EQ(bestSampleText(d), "best, accepted");
  d.outcome = SearchOutcome::no_match;
  EXPECT_EQ(bestSampleText(d), "best, no sub-pixel match");
  EXPECT_FALSE(bestAccepted(d));
  d.max_score = 800;
  EXPECT_EQ(bestSampleText(d), "best, above the limit");
  d.max_score = 2000;
  d.outcome = SearchOutcome::low_parallax;
  EXPECT_EQ(bestSampleText(d),
            std::string("best, ") + searchOutcomeName(SearchOutcome::low_parallax));
}

TEST_F(PanelText, ExportStaysWhereTabsNeedTheRoom) {
  open({}, 1280, 800, 2);
  for (const char* panel : {"Funnel", "Selection", "Log"}) {
    raisePanel(state().layout.root, panel);
    frames(2);
    const auto button = Probe::find(std::string("export:") + panel);
    ASSERT_TRUE(button) << panel;
    EXPECT_LE(button->max.x, 1280);
    for (const char* tab : {"tab:Funnel", "tab:Selection", "tab:Log", "tab:Parameters"}) {
      ASSERT_TRUE(Probe::find(tab));
      EXPECT_LE(Probe::find(tab)->max.x, button->min.x + 1) << tab;
    }
  }
}

LockstepMember member(const std::string& method, const std::string& label) {
  FakeOptions options;
  options.method = method;
  options.start = 1000;  // never
  options.lost_to = 0;
  return {std::make_unique<FakeRunner>(options), label, false};
}

class ComparedRuns : public PanelText {
 protected:
  void openRuns(const std::string& label, float scale = 1) {
    open({}, 1280, 800, scale);
    std::vector<LockstepMember> members;
    members.push_back(member("svo", "svo"));
    members.push_back(member("it-svo", label));
    runs = std::make_unique<LockstepRunner>(std::move(members), LockstepRunner::Drive::by_pump);
    compare = std::make_unique<Inspector>(*runs, host_->graphics());
    runs->send({Command::Kind::run_to_frame, 59, "", ""});
    while (runs->pump()) {
    }
    compare->state().layout = presetLayout("Compare");
  }
  std::unique_ptr<LockstepRunner> runs;
  std::unique_ptr<Inspector> compare;
};

TEST_F(ComparedRuns, WithoutAPoseThePlotsSpanTheFramesOfTheRuns) {
  openRuns("it-svo");
  const auto texts = shown(*compare, "Compare plots");
  EXPECT_EQ(compare->state().linked_x.range.lo, 0);
  EXPECT_EQ(compare->state().linked_x.range.hi, 59);
  EXPECT_EQ(countOf(texts, "50"), 1) << "the axis is labelled once, below all";
  EXPECT_EQ(countOf(texts, "no value"), 2) << "error and distance";
}

TEST_F(ComparedRuns, TabsAndCaptionsStayWithinTheirRoom) {
  openRuns("a label as long as a path with many folders and a name", 2);
  for (int i = 0; i < 3; ++i) host_->frame(*compare, false);
  const auto texts = drawnTexts([&] { host_->frame(*compare, false); });
  const auto tab = Probe::find("run:a label as long as a path with many folders and a name");
  ASSERT_TRUE(tab);
  EXPECT_LE(tab->max.x, 1280);
  EXPECT_GT(tab->min.x, Probe::find("run:svo")->max.x - 1);
  EXPECT_TRUE(anyHas(texts, "…")) << "the caption of an image";
}

}  // namespace
}  // namespace svoscope::ui
