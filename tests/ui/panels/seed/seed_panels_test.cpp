// SPDX-License-Identifier: MIT
// The panels of the depth filter: what they show equals the snapshot, stepping, brushing,
// degenerate seeds, empty states, and a lab that ends with the window.
#include <atomic>
#include <cmath>
#include <fstream>
#include <limits>
#include <thread>

#include "tests/support/scripted_runner.h"
#include "tests/ui/inspector/inspector_fixture.h"
#include "ui/model/seed_trace.h"
#include "ui/panels/filter/divergence_view.h"
#include "ui/panels/filter/filter_stats.h"
#include "ui/panels/filter/lab_view.h"
#include "ui/panels/seed/densities.h"
#include "ui/panels/seed/seed_charts.h"
#include "ui/widgets/controls.h"

namespace svoscope::ui {
namespace {

const SeedUpdateView& anUpdate(const Snapshot& s) {
  for (const SeedUpdateView& u : *s.seed_updates) {
    const SeedView* seed = findSeed(s, u.seed_id);
    if (seed && seed->visible && seed->updates > 20) return u;
  }
  return s.seed_updates->front();
}

class SeedPanels : public InspectorTest {
 protected:
  void openAt(int frame, const char* panel) {
    open({}, 1280, 900);
    runner_->runTo(frame);
    update_ = anUpdate(*runner_->latest());
    state().selection = {Selection::Kind::seed, update_.seed_id};
    maximize(panel);
    frames(4);
  }
  void maximize(const char* panel) {
    if (!hasPanel(state().layout.root, panel)) showPanel(state().layout.root, panel);
    raisePanel(state().layout.root, panel);
    state().maximized = panel;
  }
  SeedUpdateView update_;
};

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

TEST_F(SeedPanels, BrushSelectsTheSeedsInTheRectangle) {
  openAt(60, "KL / JS");
  const auto area = Probe::find("KL against JS");
  ASSERT_TRUE(area);
  InputState& input = host_->scriptInput();
  input.mouse = {area->min.x + 3, area->min.y + 3};
  frames();
  input.setButton(0, true);
  frames(2);
  input.mouse = {area->max.x - 3, area->max.y - 3};
  frames(2);
  input.setButton(0, false);
  frames(3);
  EXPECT_TRUE(state().run_options.get<DivergenceOptions>().brushed);
  std::set<std::int64_t> all;
  for (const UpdatePoint& p : inspector_->caches().own.get<FilterStats>().points())
    all.insert(p.seed_id);
  EXPECT_GT(state().highlighted.size(), all.size() / 2);
  click("Clear brush");
  EXPECT_TRUE(state().highlighted.empty());
}

TEST(FilterStats, BrushIsARectangle) {
  UpdatePoint a, b;
  a.seed_id = 1, a.kl = 0.5f, a.jsd = 0.1f;
  b.seed_id = 2, b.kl = 50, b.jsd = 0.6f;
  EXPECT_EQ(brushed({a, b, a}, 0, 1, 0, 0.2), std::vector<std::int64_t>{1});
  EXPECT_EQ(brushed({a, b}, 0, 100, 0, 0.7), (std::vector<std::int64_t>{1, 2}));
  EXPECT_TRUE(brushed({a, b}, 1, 10, 0, 1).empty());
}

TEST(FilterStats, ReadsEverySnapshotOnceAndStaysBounded) {
  FakeRunner runner;
  runner.runTo(40);
  FilterStats stats;
  while (!stats.update(runner, runner.latest())) {
  }
  const int before = stats.measurements();
  EXPECT_TRUE(stats.update(runner, runner.latest()));
  EXPECT_EQ(stats.measurements(), before);
  int expected = 0;
  for (int i = 0; i < 40; ++i) expected += static_cast<int>(pointsOf(*runner.at(i)).size());
  EXPECT_EQ(before, expected);
  runner.runTo(240);
  while (!stats.update(runner, runner.latest())) {
  }
  EXPECT_LE(stats.points().size(), FilterStats::kMostPoints);
  EXPECT_EQ(stats.run().jsd.total(), stats.measurements());
  const auto kl = stats.convergence(FilterRule::kl, 0.5),
             js = stats.convergence(FilterRule::js, 0.5);
  ASSERT_GT(kl.size(), 20u);
  EXPECT_LT(js[19], kl[19]) << "the fake JS rule is faster";
  Command reset;
  reset.kind = Command::Kind::reset;
  runner.send(reset);
  stats.update(runner, runner.latest());
  EXPECT_EQ(stats.measurements(), 0);
}

TEST(FilterStats, CalibratedGaussiansLieOnTheDiagonal) {
  std::vector<UpdatePoint> points;
  for (int i = 0; i < 2000; ++i) {  // quantiles of a Gaussian, by bisection of its cumulative
    const double q = (i + 0.5) / 2000;
    double lo = -6, hi = 6;
    for (int k = 0; k < 60; ++k)
      (std::erf((lo + hi) / 2 / M_SQRT2) / 2 + 0.5 < q ? lo : hi) = (lo + hi) / 2;
    UpdatePoint p;
    p.true_inv_distance = 0.5f;
    p.mu[FilterRule::kl] = p.mu[FilterRule::js] = static_cast<float>(1 + 0.01 * lo);
    p.sigma[FilterRule::kl] = 0.01f;
    p.sigma[FilterRule::js] = 0.005f;  // too sure by a factor of two
    points.push_back(p);
  }
  const Calibration k = calibrate(points, 2);
  EXPECT_EQ(k.count, 2000);
  EXPECT_NEAR(k.median_nees[FilterRule::kl], 0.455, 0.01);
  EXPECT_NEAR(k.median_nees[FilterRule::js], 4 * 0.455, 0.04);
  for (std::size_t i = 0; i < k.expected.size(); ++i)
    EXPECT_NEAR(k.share[FilterRule::kl][i], k.expected[i], 0.01);
  EXPECT_EQ(calibrate(points, 0).count, 0) << "no scale, no truth";
}

TEST(Bins, QuantilesAndEnds) {
  Bins bins(1e-3, 1e3, 60, true);
  for (const double v :
       {0.0, 1e-9, 1.0, 1e30, static_cast<double>(INFINITY), static_cast<double>(NAN)})
    bins.add(v);
  EXPECT_EQ(bins.total(), 5);
  EXPECT_NEAR(std::log10(bins.quantile(0.5)), 0, 0.15);
  bins.clear();
  EXPECT_TRUE(std::isnan(bins.quantile(0.5)));
}

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

TEST(LabWorker, JoinsOnDestructionAndKeepsTheNewest) {
  std::atomic<int> runs{0};
  {
    LabWorker worker([&](const LabOptions& o) {
      ++runs;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      LabResult r;
      r.options = o;
      return r;
    });
    LabOptions options;
    options.seeds = 800;
    worker.start(options);
    options.seeds = 1600;
    worker.start(options);
    for (int i = 0; i < 400 && worker.state().running; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    ASSERT_TRUE(worker.state().result);
    EXPECT_EQ(worker.state().result->options.seeds, 1600);
    EXPECT_EQ(worker.state().progress, 1);
    worker.start(options);
    worker.cancel();
    EXPECT_FALSE(worker.state().running);
    worker.start(options);
  }  // destroyed while it runs
  EXPECT_GT(runs, 0);
}

TEST(Lab, TwoViewsFollowTheLawOfSines) {
  const TwoViews v = twoViews(0.3, 2.5, 1, 525);
  EXPECT_LT(v.near_m, 2.5);
  EXPECT_GT(v.far_m, 2.5);
  EXPECT_NEAR(v.tau, 1.0 / 525 / 0.3, 2e-4) << "about noise / (focal baseline) for a small angle";
  EXPECT_TRUE(std::isinf(twoViews(0.01, 10, 20, 525).far_m)) << "beyond the horizon";
  EXPECT_TRUE(std::isfinite(twoViews(0.01, 10, 20, 525).tau));
}

TEST(Lab, DivergencesOverSeparation) {
  SeparationCurves curves;
  curves.update(0.2f, 0.1f);
  ASSERT_GT(curves.jsd.size(), 10u);
  EXPECT_LE(curves.jsd.back(), std::log(2.0) + 1e-6);
  EXPECT_NEAR(curves.jsd.back(), std::log(2.0), 1e-3);
  EXPECT_GT(curves.kl_pq.back(), 20) << "KL has no limit";
}

}  // namespace
}  // namespace svoscope::ui
