// SPDX-License-Identifier: MIT
// Random sample consensus with local optimisation (Chum, Matas, Kittler 2003), deterministic: the
// generator is seeded by the caller and nothing else is random.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "engine/geometry/two_view_models.h"

namespace svoscope {

/// `count` different indices below `size`. The modulo keeps the sequence the same on every
/// standard library, unlike std::uniform_int_distribution.
inline std::vector<int> drawSample(std::mt19937& rng, int size, int count) {
  std::vector<int> sample;
  while (static_cast<int>(sample.size()) < count) {
    const int i = static_cast<int>(rng() % static_cast<unsigned>(size));
    if (std::find(sample.begin(), sample.end(), i) == sample.end()) sample.push_back(i);
  }
  return sample;
}

/// Samples needed to draw one free of outliers with 99.9 % probability.
inline int samplesNeeded(double inlier_ratio, int sample_size, int limit) {
  const double good = std::pow(inlier_ratio, sample_size);
  if (good >= 1 - 1e-9) return 1;
  const double needed = std::log(1e-3) / std::log1p(-std::max(good, 1e-12));
  return static_cast<int>(std::min<double>(limit, std::ceil(needed)));
}

/// The model of the lowest cost among `starts` and those of random samples. minimal(sample) gives
/// models, polish(model, rounds) improves one on all data, cost(model) is a truncatedCost.
template <typename Model, typename Minimal, typename Polish, typename Cost>
Model randomSearch(const TwoViewData& data, int sample_size, const std::vector<Model>& starts,
                   Minimal minimal, Polish polish, Cost cost) {
  std::mt19937 rng(data.seed);
  Model best{};
  double best_cost = 2.0 * data.size() + 1;
  const auto consider = [&](const Model& model) {
    if (cost(model) >= 1.05 * best_cost) return;
    const Model better = polish(model, 3);
    const double c = cost(better);
    if (c < best_cost) {
      best_cost = c;
      best = better;
    }
  };
  for (const Model& start : starts) consider(start);
  // The truncated cost bounds the outliers from above: 1 - cost / n is a cautious inlier ratio.
  const auto needed = [&] {
    const double ratio = std::clamp(1 - best_cost / data.size(), 0.05, 1.0);
    return samplesNeeded(ratio, sample_size, data.max_samples);
  };
  constexpr int kMinSamples = 10;  // a start may sit in a local minimum that fits well
  for (int k = 0; k < std::max(kMinSamples, needed()); ++k)
    for (const Model& model : minimal(drawSample(rng, data.size(), sample_size))) consider(model);
  return polish(best, 8);
}

}  // namespace svoscope
