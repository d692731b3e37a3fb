// SPDX-License-Identifier: MIT
// How KL and JS differ over all updates, and the brush in the panel that shows it.
#include "ui/panels/filter/filter_stats.h"

#include <cmath>
#include <set>

#include "tests/ui/panels/seed/seed_panels_fixture.h"
#include "ui/panels/filter/divergence_view.h"

namespace svoscope::ui {
namespace {

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

}  // namespace
}  // namespace svoscope::ui
