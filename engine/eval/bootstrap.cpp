// SPDX-License-Identifier: MIT
#include "engine/eval/bootstrap.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace svoscope {

namespace {

/// The distribution of the standard library differs between implementations; this does not.
std::size_t draw(std::mt19937_64& random, std::size_t count) {
  return static_cast<std::size_t>(random() % count);
}

double resampledMean(std::mt19937_64& random, const std::vector<double>& values) {
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) sum += values[draw(random, values.size())];
  return sum / static_cast<double>(values.size());
}

Interval percentiles(std::vector<double> values, double level) {
  std::sort(values.begin(), values.end());
  const auto at = [&](double fraction) {
    const double position = fraction * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(position);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    const double part = position - static_cast<double>(below);
    return (1 - part) * values[below] + part * values[above];
  };
  return {at(0.5 * (1 - level)), at(1 - 0.5 * (1 - level))};
}

}  // namespace

double meanOf(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

Interval bootstrapMean(const std::vector<double>& values, const BootstrapOptions& options) {
  if (values.empty() || options.resamples < 1) return {};
  std::mt19937_64 random(options.seed);
  std::vector<double> means;
  for (int i = 0; i < options.resamples; ++i) means.push_back(resampledMean(random, values));
  return percentiles(std::move(means), options.level);
}

PairedDifference bootstrapPaired(const std::vector<PairedGroup>& groups,
                                 const BootstrapOptions& options) {
  PairedDifference result;
  result.groups = static_cast<int>(groups.size());
  if (groups.empty() || options.resamples < 1) return result;
  const auto n = static_cast<double>(groups.size());
  for (const PairedGroup& g : groups) result.mean += (meanOf(g.a) - meanOf(g.b)) / n;
  std::mt19937_64 random(options.seed);
  std::vector<double> means;
  for (int i = 0; i < options.resamples; ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < groups.size(); ++k) {
      const PairedGroup& g = groups[draw(random, groups.size())];
      sum += resampledMean(random, g.a) - resampledMean(random, g.b);
    }
    means.push_back(sum / n);
  }
  result.interval = percentiles(std::move(means), options.level);
  return result;
}

}  // namespace svoscope
