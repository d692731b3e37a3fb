// SPDX-License-Identifier: MIT
#include "engine/mapping/seed_update.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/plane_scene.h"

namespace svoscope {
namespace {

Seed seedAt(double mu, double sigma) {
  Seed seed;
  seed.belief = {mu, sigma * sigma, 10, 10};
  seed.range = 1;
  return seed;
}

SeedMeasurement matched(double x, double tau) { return {1, 0, 7, SearchOutcome::matched, x, tau}; }
SeedMeasurement outcome(SearchOutcome o) { return {1, 0, 7, o, 0, 0}; }

TEST(MakeSeed, StartsFromTheDepthsOfTheScene) {
  const Pinhole camera = test::smallCamera();
  const DetectedFeature feature{Vec2(100, 50), 1, FeatureType::edgelet, 12.0, Vec2(0, 1)};
  const Seed seed = makeSeed(feature, camera, 4.0, 0.8, {});
  EXPECT_EQ(seed.status, SeedStatus::active);
  EXPECT_DOUBLE_EQ(seed.belief.mu, 0.25);
  EXPECT_DOUBLE_EQ(seed.range, 1 / 0.4);
  EXPECT_NEAR(seed.belief.sigma2, seed.range * seed.range / 36, 1e-12);
  EXPECT_EQ(seed.belief.a, 10);
  EXPECT_EQ(seed.belief.b, 10);
  EXPECT_EQ(seed.anchor.px, feature.px);
  EXPECT_LT((seed.anchor.f - camera.bearing(feature.px)).norm(), 1e-12);
  EXPECT_EQ(seed.anchor.level, 1);
  EXPECT_EQ(seed.anchor.type, FeatureType::edgelet);
  EXPECT_EQ(seed.anchor.gradient_dir, Vec2(0, 1));
}

TEST(ApplyMeasurement, AMatchUpdatesTheBelief) {
  Seed seed = seedAt(0.5, 0.1);
  applyMeasurement(seed, matched(0.55, 0.05), {});
  EXPECT_GT(seed.belief.mu, 0.5);
  EXPECT_LT(seed.belief.sigma2, 0.01);
  EXPECT_EQ(seed.updates, 1);
  EXPECT_EQ(seed.failures, 0);
  EXPECT_EQ(seed.last_frame, 7);
  EXPECT_EQ(seed.last_x, 0.55);
  EXPECT_EQ(seed.last_tau, 0.05);
  EXPECT_EQ(seed.outcome, SearchOutcome::matched);
  EXPECT_EQ(seed.status, SeedStatus::active);
}

TEST(ApplyMeasurement, AFailedSearchIsOneOutlierSeen) {
  Seed seed = seedAt(0.5, 0.1);
  applyMeasurement(seed, outcome(SearchOutcome::no_match), {});
  EXPECT_EQ(seed.belief.b, 11);
  EXPECT_EQ(seed.belief.a, 10);
  EXPECT_EQ(seed.belief.mu, 0.5);
  EXPECT_EQ(seed.failures, 1);
  EXPECT_EQ(seed.updates, 0);
}

TEST(ApplyMeasurement, OutcomesWithoutInformationLeaveTheBelief) {
  for (const SearchOutcome o :
       {SearchOutcome::out_of_view, SearchOutcome::low_parallax, SearchOutcome::edge_parallel}) {
    Seed seed = seedAt(0.5, 1e-4);  // would converge if it were looked at
    applyMeasurement(seed, outcome(o), {});
    EXPECT_EQ(seed.belief.b, 10);
    EXPECT_EQ(seed.failures, 0);
    EXPECT_EQ(seed.status, SeedStatus::active);
    EXPECT_EQ(seed.outcome, o);
  }
}

TEST(ApplyMeasurement, ConvergesOnlyWithSmallSigmaAndEnoughInliers) {
  const DepthFilterParameters p;
  Seed seed = seedAt(0.5, 0.0049);
  seed.belief.a = 11;
  applyMeasurement(seed, matched(0.5, 0.02), p);
  EXPECT_EQ(seed.status, SeedStatus::converged);
  Seed wide = seedAt(0.5, 0.02);
  wide.belief.a = 30;
  applyMeasurement(wide, matched(0.5, 0.02), p);
  EXPECT_EQ(wide.status, SeedStatus::active);
  Seed hopeless = seedAt(0.5, 0.001);  // sharp, but hardly ever confirmed
  hopeless.belief.b = 30;
  applyMeasurement(hopeless, matched(0.5, 0.001), p);
  EXPECT_EQ(hopeless.status, SeedStatus::active);
}

TEST(ApplyMeasurement, RejectedWhenInliersRunOutOrTheDepthTurnsNegative) {
  Seed seed = seedAt(0.5, 0.1);
  int misses = 0;
  while (seed.status == SeedStatus::active && misses < 1000) {
    applyMeasurement(seed, outcome(SearchOutcome::no_match), {});
    ++misses;
  }
  EXPECT_EQ(seed.status, SeedStatus::rejected);
  EXPECT_EQ(misses, 106);  // 10 / (20 + n) < 0.08
  Seed behind = seedAt(0.01, 0.2);
  applyMeasurement(behind, matched(-0.3, 0.05), {});
  EXPECT_EQ(behind.status, SeedStatus::rejected);
}

TEST(ApplyMeasurement, NaNLeavesTheBelief) {
  Seed seed = seedAt(0.5, 0.1);
  applyMeasurement(seed, matched(std::nan(""), 0.1), {});
  applyMeasurement(seed, matched(0.5, std::nan("")), {});
  EXPECT_EQ(seed.belief.mu, 0.5);
  EXPECT_EQ(seed.belief.a, 10);
  EXPECT_EQ(seed.status, SeedStatus::active);
}

/// A job that measures `seeds` of keyframe 0 at the origin in a new view.
MappingJob jobFor(const test::PlaneScene& scene, const std::vector<Seed>& seeds,
                  const PyramidPtr& reference, const SE3& T_cam_world, int frame) {
  MappingJob job;
  job.frame_index = frame;
  job.camera = scene.camera();
  job.T_cam_world = T_cam_world;
  job.pyramid = scene.pyramid(T_cam_world, 4);
  job.keyframes.push_back({0, reference, SE3()});
  for (const Seed& s : seeds) {
    if (s.status == SeedStatus::active)
      job.seeds.push_back({s.id, 0, s.anchor, s.belief.mu, std::sqrt(s.belief.sigma2)});
  }
  return job;
}

std::vector<Seed> detectSeeds(const test::PlaneScene& scene, const PyramidPtr& reference) {
  MappingJob job;
  job.camera = scene.camera();
  job.pyramid = reference;
  job.new_seeds.wanted = true;
  job.new_seeds.keyframe_id = 0;
  job.new_seeds.occupied = OccupancyGrid(320, 240, 30);
  job.new_seeds.median_depth = 2.6;  // 30 % too far: the filter has to work
  job.new_seeds.min_depth = 1.2;
  const MappingResult result = runMappingJob(job, {});
  std::vector<Seed> seeds;
  for (const NewSeed& fresh : result.new_seeds) {
    seeds.push_back(
        makeSeed(fresh.feature, scene.camera(), result.median_depth, result.min_depth, {}));
    seeds.back().id = static_cast<std::int64_t>(seeds.size()) - 1;
  }
  return seeds;
}

TEST(MappingJob, SeedsConvergeToTheTrueDepth) {
  const test::PlaneScene scene(test::smallCamera(), Vec3(0.3, 0.1, 1), 2, 0.055);
  const PyramidPtr reference = scene.pyramid(SE3(), 4);
  std::vector<Seed> seeds = detectSeeds(scene, reference);
  ASSERT_GT(seeds.size(), 60u);
  for (int k = 1; k <= 16; ++k) {
    const SE3 T(so3Exp(Vec3(0, 0.004 * k, 0)), Vec3(-0.025 * k, 0.012 * k, 0));
    for (const SeedMeasurement& m :
         runMappingJob(jobFor(scene, seeds, reference, T, k), {}).measurements) {
      EXPECT_EQ(m.frame_index, k);
      applyMeasurement(seeds[static_cast<std::size_t>(m.seed_id)], m, {});
    }
  }
  int converged = 0, wrong = 0;
  for (const Seed& s : seeds) {
    if (s.status != SeedStatus::converged) continue;
    ++converged;
    const double truth = scene.inverseDistance(SE3(), s.anchor.px);
    wrong += std::abs(s.belief.mu - truth) > 0.02 * truth;
  }
  EXPECT_GT(converged, 0.6 * static_cast<double>(seeds.size()));
  EXPECT_LE(wrong, 0.05 * converged);
}

TEST(MappingJob, NewSeedsAreMeasuredAgainstOlderViews) {
  const test::PlaneScene scene(test::smallCamera(), Vec3::UnitZ(), 2, 0.055);
  MappingJob job;
  job.camera = scene.camera();
  job.pyramid = scene.pyramid(SE3(), 4);
  job.new_seeds.wanted = true;
  job.new_seeds.occupied = OccupancyGrid(320, 240, 30);
  job.new_seeds.median_depth = 2.2;
  job.new_seeds.min_depth = 1.5;
  const SE3 older(Eigen::Quaterniond::Identity(), Vec3(0.15, 0, 0));
  job.older_views.push_back({3, scene.pyramid(older, 4), older});
  const MappingResult result = runMappingJob(job, {});
  int measured = 0, good = 0;
  for (const NewSeed& fresh : result.new_seeds) {
    for (const SeedMeasurement& m : fresh.measurements) {
      ++measured;
      good += std::abs(m.x - scene.inverseDistance(SE3(), fresh.feature.px)) < m.tau;
    }
  }
  EXPECT_GT(measured, 0.5 * static_cast<double>(result.new_seeds.size()));
  EXPECT_GT(good, 0.9 * measured);
}

TEST(MappingJob, TakesNoMoreSeedsThanAllowed) {
  const test::PlaneScene scene(test::smallCamera(), Vec3::UnitZ(), 2, 0.055);
  MappingJob job;
  job.camera = scene.camera();
  job.pyramid = scene.pyramid(SE3(), 4);
  job.new_seeds.wanted = true;
  job.new_seeds.occupied = OccupancyGrid(320, 240, 30);
  MappingParameters p;
  p.filter.max_seeds_per_keyframe = 11;
  EXPECT_EQ(runMappingJob(job, p).new_seeds.size(), 11u);
  job.new_seeds.wanted = false;
  EXPECT_TRUE(runMappingJob(job, p).new_seeds.empty());
}

}  // namespace
}  // namespace svoscope
