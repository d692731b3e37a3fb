// SPDX-License-Identifier: MIT
#include "engine/runner/search_detail.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "engine/mapping/divergence.h"
#include "engine/mapping/seed_update.h"
#include "engine/runner/make_runner.h"

namespace svoscope {
namespace {

std::unique_ptr<Runner> runRoom(const std::string& method, int frames) {
  auto sequence = openSequence("synthetic:room");
  EXPECT_TRUE(sequence.ok());
  RunnerOptions options;
  options.method = method;
  options.threaded = false;
  auto runner = makeRunner(std::move(sequence).value(), options);
  EXPECT_TRUE(runner.ok());
  Command run;
  run.kind = Command::Kind::run_to_frame;
  run.frame = frames;
  runner.value()->send(run);
  while (runner.value()->pump()) {
  }
  return std::move(runner).value();
}

class SearchDetailTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { runner_ = runRoom("it-svo", 70).release(); }
  static void TearDownTestSuite() { delete runner_; }
  static Runner* runner_;
};
Runner* SearchDetailTest::runner_ = nullptr;

const SeedView* findSeed(const Snapshot& s, std::int64_t id) {
  for (const SeedView& seed : *s.seeds) {
    if (seed.id == id) return &seed;
  }
  return nullptr;
}

/// A local adjustment may rescale a keyframe's seeds, mean and sigma alike; nothing else changes a
/// belief between its updates.
void expectSameBelief(const BeliefView& a, const BeliefView& b, bool same_scale) {
  EXPECT_EQ(a.a, b.a);
  EXPECT_EQ(a.b, b.b);
  if (same_scale) {
    EXPECT_EQ(a.mu, b.mu);
    EXPECT_EQ(a.sigma, b.sigma);
  } else {
    const float scale = b.mu / a.mu;
    EXPECT_NEAR(scale, 1, 0.2f);
    EXPECT_NEAR(b.sigma, scale * a.sigma, 1e-5f * b.sigma);
  }
}

TEST_F(SearchDetailTest, SnapshotsHoldEveryUpdateOfBothRules) {
  int updates = 0;
  std::map<std::int64_t, std::pair<SeedUpdateView, int>> last;  // with the frame
  int last_keyframe = -1;
  for (int i = 0; i <= 70; ++i) {
    const SnapshotPtr s = runner_->at(i);
    ASSERT_TRUE(s && s->seed_updates && s->mapping);
    EXPECT_EQ(s->mapping->filter.rule, FilterRule::js);
    int successful = 0;
    for (const SeedUpdateView& u : *s->seed_updates) {
      const bool measured =
          u.outcome == SearchOutcome::matched || u.outcome == SearchOutcome::tracked;
      successful += measured;
      for (const float v :
           {u.score, u.x, u.tau, u.before[FilterRule::kl].mu, u.after[FilterRule::kl].sigma,
            u.before[FilterRule::js].mu, u.after[FilterRule::js].sigma, u.jsd, u.affinity,
            u.kl_belief_measurement, u.kl_measurement_belief})
        ASSERT_TRUE(std::isfinite(v));
      EXPECT_GE(u.jsd, 0);
      EXPECT_LE(u.jsd, static_cast<float>(kLog2) + 1e-6f);
      if (measured) {
        EXPECT_GT(u.tau, 0);
      }
      // The chain of a seed's updates is unbroken.
      const auto before = last.find(u.seed_id);
      if (before != last.end()) {
        const bool same_scale = before->second.second > last_keyframe;
        expectSameBelief(before->second.first.after[FilterRule::kl], u.before[FilterRule::kl],
                         same_scale);
        expectSameBelief(before->second.first.after[FilterRule::js], u.before[FilterRule::js],
                         same_scale);
      }
      last[u.seed_id] = {u, i};
    }
    EXPECT_EQ(successful, s->record.seed_updates) << "frame " << i;
    if (s->record.is_keyframe) last_keyframe = i;
    updates += successful;
  }
  EXPECT_GT(updates, 1000);
  for (const SeedView& seed : *runner_->latest()->seeds) {
    if (seed.type == FeatureType::segment) continue;  // segment seeds carry the rule in use only
    EXPECT_EQ(seed.mu, seed.belief[FilterRule::js].mu);
    EXPECT_EQ(seed.sigma, seed.belief[FilterRule::js].sigma);
    EXPECT_GT(seed.belief[FilterRule::kl].sigma, 0);
    const auto update = last.find(seed.id);
    if (update != last.end())
      expectSameBelief(update->second.first.after[FilterRule::kl], seed.belief[FilterRule::kl],
                       update->second.second > last_keyframe);
  }
}

TEST_F(SearchDetailTest, EqualsTheEnginesOwnSearch) {
  int explained = 0, agreeing = 0;
  for (int i = 40; i <= 70; ++i) {
    const SnapshotPtr s = runner_->at(i);
    for (const SeedUpdateView& u : *s->seed_updates) {
      const SeedView* seed = findSeed(*s, u.seed_id);
      // Tracking searches from the predicted pose, which the snapshot does not hold.
      if (!seed || u.frame_index != i || u.outcome != SearchOutcome::matched) continue;
      const auto detail = explainSearch(*seed, u, *s, runner_->info());
      ASSERT_TRUE(detail.ok()) << detail.error().message();
      const SearchDetail& d = detail.value();
      EXPECT_EQ(d.patch_reference.size(), cv::Size(24, 24));
      EXPECT_EQ(d.patch_warped.size(), cv::Size(8, 8));
      EXPECT_EQ(d.patch_match.size(), cv::Size(8, 8));
      EXPECT_EQ(d.px_match, u.px);
      EXPECT_EQ(d.profile.empty(), u.score == 0) << "a scan has a score";
      if (d.profile.empty()) continue;
      ASSERT_GE(d.best, 0);
      const SearchSample& best = d.profile[static_cast<std::size_t>(d.best)];
      EXPECT_LE(best.score, d.max_score);
      ++explained;
      // Values in snapshots are single precision: now and then a sample rounds to the next pixel.
      agreeing += std::abs(best.score - u.score) <= 1e-3f * u.score + 1e-3f;
      EXPECT_LE((best.px - u.px).norm(), 8.0f * static_cast<float>(1 << d.search_level) + 1e-3f);
      if (d.second >= 0) {
        EXPECT_GE(d.profile[static_cast<std::size_t>(d.second)].score, best.score);
      }
      for (std::size_t k = 1; k < d.profile.size(); ++k)
        EXPECT_LE(d.profile[k - 1].inv_distance, d.profile[k].inv_distance);
    }
  }
  EXPECT_GT(explained, 100);
  EXPECT_GE(agreeing, explained * 95 / 100);
}

TEST_F(SearchDetailTest, MeasurementsInOlderViewsNeedALaterSnapshot) {
  int older = 0;
  for (int i = 1; i <= 70; ++i) {
    const SnapshotPtr s = runner_->at(i);
    for (const SeedUpdateView& u : *s->seed_updates) {
      const SeedView* seed = findSeed(*s, u.seed_id);
      if (!seed || u.frame_index >= i) continue;
      const SnapshotPtr searched = runner_->at(u.frame_index);
      ASSERT_TRUE(searched);
      EXPECT_FALSE(explainSearch(*seed, u, *searched, runner_->info()).ok());
      EXPECT_TRUE(explainSearch(*seed, u, *searched, runner_->info(), s.get()).ok());
      if (++older > 20) return;
    }
  }
  EXPECT_GT(older, 0);
}

TEST(SeedInspection, PlainRunsKeepNoUpdates) {
  auto sequence = openSequence("synthetic:room");
  RunnerOptions options;
  options.threaded = false;
  options.publish_snapshots = false;
  options.max_frames = 30;
  auto runner = makeRunner(std::move(sequence).value(), options);
  Command play;
  play.kind = Command::Kind::play;
  runner.value()->send(play);
  while (runner.value()->pump()) {
  }
  ASSERT_TRUE(runner.value()->latest());
  EXPECT_TRUE(runner.value()->latest()->seed_updates->empty());
}

TEST(SeedInspection, UnknownMethodsAreUsageErrors) {
  RunnerOptions options;
  options.method = "orb";
  const auto runner = makeRunner(std::move(openSequence("synthetic:room")).value(), options);
  ASSERT_FALSE(runner.ok());
  EXPECT_EQ(runner.error().kind, ErrorKind::usage);
}

TEST(SeedInspection, TheShadowDoesNotChangeTheRun) {
  std::vector<FrameRecord> records[2];
  for (int on = 0; on < 2; ++on) {
    RunnerOptions options;
    options.threaded = false;
    options.max_frames = 40;
    options.parameters.tracker.mapping.filter.shadow = on != 0;
    auto runner = makeRunner(std::move(openSequence("synthetic:room")).value(), options);
    Command play;
    play.kind = Command::Kind::play;
    runner.value()->send(play);
    while (runner.value()->pump()) {
    }
    records[on] = runner.value()->records(0);
  }
  ASSERT_EQ(records[0].size(), records[1].size());
  for (std::size_t i = 0; i < records[0].size(); ++i)
    EXPECT_EQ(records[0][i].T_world_cam.translation(), records[1][i].T_world_cam.translation());
}

}  // namespace
}  // namespace svoscope
