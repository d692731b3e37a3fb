// SPDX-License-Identifier: MIT
// The filter lab: its worker ends with the window, its curves follow from the formulas.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

#include "ui/panels/filter/lab_view.h"

namespace svoscope::ui {
namespace {

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
