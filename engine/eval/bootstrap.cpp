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

/// Tail of the percentile interval of `n` values that makes it as wide as Student's would be.
double expandedTail(double level, std::size_t n) {
  if (n < 2) return 0.5 * (1 - level);
  const double dof = static_cast<double>(n) - 1;
  const double z =
      std::sqrt((dof + 1) / dof) * studentQuantile(0.5 * (1 + level), static_cast<int>(n) - 1);
  return 0.5 * std::erfc(z / std::sqrt(2.0));
}

Interval percentiles(std::vector<double> values, double level, std::size_t n) {
  std::sort(values.begin(), values.end());
  const auto at = [&](double fraction) {
    const double position = fraction * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(position);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    const double part = position - static_cast<double>(below);
    return (1 - part) * values[below] + part * values[above];
  };
  const double tail = expandedTail(level, n);
  return {at(tail), at(1 - tail)};
}

}  // namespace

double studentQuantile(double fraction, int degrees_of_freedom) {
  const double n = degrees_of_freedom;
  const double scale =
      std::exp(std::lgamma(0.5 * (n + 1)) - std::lgamma(0.5 * n)) / std::sqrt(n * M_PI);
  // With t = sqrt(n) tan(a) the density becomes a power of the cosine, over a finite range.
  const auto cdf = [&](double t) {
    const double end = std::atan(t / std::sqrt(n));
    constexpr int kSteps = 400;  // Simpson
    double sum = 0;
    for (int i = 0; i <= kSteps; ++i) {
      const double weight = i == 0 || i == kSteps ? 1 : i % 2 ? 4 : 2;
      sum += weight * std::pow(std::cos(end * i / kSteps), n - 1);
    }
    return 0.5 + scale * std::sqrt(n) * sum * end / (3 * kSteps);
  };
  double low = 0, high = 1e3;
  for (int i = 0; i < 60; ++i)
    (cdf(0.5 * (low + high)) < fraction ? low : high) = 0.5 * (low + high);
  return 0.5 * (low + high);
}

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
  return percentiles(std::move(means), options.level, values.size());
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
  const PairedGroup& first = groups.front();
  const std::size_t values =
      groups.size() > 1 ? groups.size() : std::min(first.a.size(), first.b.size());
  result.interval = percentiles(std::move(means), options.level, values);
  return result;
}

}  // namespace svoscope
