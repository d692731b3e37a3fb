// SPDX-License-Identifier: MIT
// What the depth filter costs: single updates, divergences, and whole mapping frames by rule.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <random>
#include <string>

#include "engine/dataset/sequence.h"
#include "engine/frame/rectifier.h"
#include "engine/mapping/divergence.h"
#include "engine/mapping/seed_update.h"

namespace {

using namespace svoscope;

struct Cases {
  std::vector<Belief> beliefs;
  std::vector<Measurement> measurements;
  Cases() {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> u(0, 1);
    for (int i = 0; i < 1024; ++i) {
      beliefs.push_back({0.2 + u(random), std::pow(10, -6 + 5 * u(random)), 10, 10});
      const double tau2 = std::pow(10, -6 + 5 * u(random));
      measurements.push_back({beliefs.back().mu + std::sqrt(tau2) * (u(random) - 0.5), tau2, 1});
    }
  }
};

void update(benchmark::State& state, FilterRule rule) {
  const Cases cases;
  JsdTable::instance();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        updateBelief(rule, cases.beliefs[i & 1023], cases.measurements[i & 1023], {}));
    ++i;
  }
}

void divergence(benchmark::State& state, bool table) {
  const Cases cases;
  JsdTable::instance();
  std::size_t i = 0;
  for (auto _ : state) {
    const Belief& q = cases.beliefs[i & 1023];
    const Measurement& m = cases.measurements[i & 1023];
    benchmark::DoNotOptimize(table ? agreement(q.mu, q.sigma2, m.x, m.tau2)
                                   : agreementNumeric(q.mu, q.sigma2, m.x, m.tau2));
    ++i;
  }
}

/// Seeds of the first frame of the built-in room, searched for in the frames after with true poses.
struct Scene {
  Pinhole camera;
  std::vector<JobKeyframe> views;
  std::vector<Seed> seeds;
  bool good = false;

  Scene() {
    auto sequence = openSequence("synthetic:room");
    if (!sequence.ok()) return;
    const Rectifier rectifier(sequence.value()->camera());
    camera = rectifier.pinhole();
    for (int i = 0; i < 12; ++i) {
      const auto image = sequence.value()->read(i);
      if (!image.ok()) return;
      const cv::Mat gray = rectifier.rectify(image.value().gray);
      const SE3 T_world_cam =
          sequence.value()->groundTruth()[static_cast<std::size_t>(i)].T_world_cam;
      views.push_back({i, buildPyramid(gray, pyramidLevels(gray.cols)), T_world_cam.inverse(), i});
    }
    const OccupancyGrid empty(camera.width, camera.height, scaledCell(30, camera.width));
    for (const DetectedFeature& f : detectFeatures(*views[0].pyramid, {}, empty))
      seeds.push_back(makeSeed(f, camera, 2.5, 1, {}));
    good = true;
  }
};

/// What mapping does per frame: the job, and its measurements applied.
void mappingFrame(benchmark::State& state, FilterRule rule, bool shadow) {
  static const Scene scene;
  if (!scene.good) return state.SkipWithError("the built-in sequence cannot be read");
  JsdTable::instance();
  MappingParameters p;
  p.filter.rule = rule;
  p.filter.shadow = shadow;
  int updates = 0;
  for (auto _ : state) {
    std::vector<Seed> seeds = scene.seeds;
    for (std::size_t v = 1; v < scene.views.size(); ++v) {
      MappingJob job;
      job.frame_index = scene.views[v].frame_index;
      job.pyramid = scene.views[v].pyramid;
      job.T_cam_world = scene.views[v].T_cam_world;
      job.camera = scene.camera;
      job.keyframes = {scene.views[0]};
      for (const Seed& s : seeds)
        job.seeds.push_back({s.id, 0, s.anchor, s.belief.mu, std::sqrt(s.belief.sigma2)});
      const MappingResult result = runMappingJob(job, p);
      for (std::size_t i = 0; i < seeds.size(); ++i)
        applyMeasurement(seeds[i], result.measurements[i], p.filter);
      updates += static_cast<int>(seeds.size());
    }
  }
  state.SetItemsProcessed(updates);
}

BENCHMARK_CAPTURE(divergence, jsd_table, true);
BENCHMARK_CAPTURE(divergence, jsd_numeric, false);

/// Every rule alone, and with the others as its shadows.
void registerRules() {
  for (const FilterRule rule : kRules) {
    const std::string id = ruleInfo(rule).id;
    benchmark::RegisterBenchmark(("update/" + id).c_str(), update, rule);
    for (const bool shadow : {false, true}) {
      const std::string name = "mappingFrame/" + id + (shadow ? "_with_shadow" : "");
      benchmark::RegisterBenchmark(name.c_str(), mappingFrame, rule, shadow)
          ->Unit(benchmark::kMillisecond);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  registerRules();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
