// SPDX-License-Identifier: MIT
#include "engine/mapping/divergence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace svoscope {

namespace {

constexpr double kLogSqrtTwoPi = 0.91893853320467274178;
constexpr double kReach = 8;      // standard deviations on either side
constexpr int kGridPoints = 321;  // of jsdNumeric, per Gaussian
constexpr int kPerUnit = 8;       // nodes of the table per unit of offset and of log ratio
constexpr int kOffsetNodes = static_cast<int>(JsdTable::kMostOffset) * kPerUnit + 1;
constexpr int kRatioNodes = static_cast<int>(JsdTable::kMostLogRatio) * kPerUnit + 1;
constexpr int kColumns = kOffsetNodes + 3, kRows = kRatioNodes + 3;

bool proper(double mean1, double v1, double mean2, double v2) {
  return std::isfinite(mean1) && std::isfinite(mean2) && std::isfinite(v1) && std::isfinite(v2) &&
         v1 > 0 && v2 > 0;
}

/// log(1 + exp(x)) without overflow.
double softplus(double x) { return x > 0 ? x + std::log1p(std::exp(-x)) : std::log1p(std::exp(x)); }

struct Gaussian {
  double mean, sigma, log_scale;
  Gaussian(double m, double s) : mean(m), sigma(s), log_scale(std::log(s) + kLogSqrtTwoPi) {}
  double log(double x) const {
    const double t = (x - mean) / sigma;
    return -0.5 * t * t - log_scale;
  }
};

/// Integrand of log 2 - J: no term cancels another, so it stays exact down to the limit.
double overlapDensity(const Gaussian& p, const Gaussian& q, double x) {
  const double lp = p.log(x), lq = q.log(x);
  return 0.5 * (std::exp(lp) * softplus(lq - lp) + std::exp(lq) * softplus(lp - lq));
}

/// log 2 - J by Gauss-Legendre quadrature on panels of at most one standard deviation of either.
double overlap(const Gaussian& p, const Gaussian& q) {
  constexpr std::array<double, 3> kNode = {0.238619186083196909, 0.661209386466264514,
                                           0.932469514203152028};
  constexpr std::array<double, 3> kWeight = {0.467913934572691047, 0.360761573048138608,
                                             0.171324492379170345};
  std::vector<double> ends;
  for (const Gaussian& g : {p, q}) {
    for (int i = -8; i <= 8; ++i) ends.push_back(g.mean + g.sigma * i);
  }
  std::sort(ends.begin(), ends.end());
  double sum = 0;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const double middle = 0.5 * (ends[i - 1] + ends[i]), half = 0.5 * (ends[i] - ends[i - 1]);
    if (half <= 0) continue;
    for (std::size_t k = 0; k < kNode.size(); ++k) {
      const double x = half * kNode[k];
      sum +=
          half * kWeight[k] * (overlapDensity(p, q, middle - x) + overlapDensity(p, q, middle + x));
    }
  }
  return sum;
}

/// Weights of the cubic through the nodes -1, 0, 1, 2 at t in [0, 1].
std::array<double, 4> cubicWeights(double t) {
  const double u = t - 1, v = t + 1, w = t - 2;
  return {-t * u * w / 6, v * u * w / 2, -v * t * w / 2, v * t * u / 6};
}

}  // namespace

double klGaussian(double mean1, double v1, double mean2, double v2) {
  if (!proper(mean1, v1, mean2, v2)) return std::numeric_limits<double>::infinity();
  const double offset = mean1 - mean2;
  return std::max(0.0, 0.5 * (std::log(v2 / v1) + (v1 + offset * offset) / v2 - 1));
}

double jsdNumeric(double mean1, double v1, double mean2, double v2) {
  if (!proper(mean1, v1, mean2, v2)) return kLog2;
  const Gaussian p(mean1, std::sqrt(v1)), q(mean2, std::sqrt(v2));
  std::vector<double> grid;
  grid.reserve(2 * kGridPoints);
  for (const Gaussian& g : {p, q}) {
    for (int i = 0; i < kGridPoints; ++i)
      grid.push_back(g.mean + g.sigma * (2 * kReach * i / (kGridPoints - 1) - kReach));
  }
  std::inplace_merge(grid.begin(), grid.begin() + kGridPoints, grid.end());
  double sum = 0, last = 0;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const double lp = p.log(grid[i]), lq = q.log(grid[i]);
    const double y = 0.5 * (std::exp(lp) * (kLog2 - softplus(lq - lp)) +
                            std::exp(lq) * (kLog2 - softplus(lp - lq)));
    if (i > 0) sum += 0.5 * (y + last) * (grid[i] - grid[i - 1]);
    last = y;
  }
  return std::clamp(sum, 0.0, kLog2);
}

JsdTable::JsdTable() : values_(static_cast<std::size_t>(kRows) * kColumns) {
  for (int row = 0; row < kRows; ++row) {
    // With sigma1^2 + sigma2^2 = 1 the offset of the means is d itself.
    const double ratio = std::exp(static_cast<double>(row - 1) / kPerUnit);
    const double narrow = 1 / std::sqrt(1 + ratio * ratio);
    for (int column = 0; column < kColumns; ++column) {
      const double offset = static_cast<double>(column - 1) / kPerUnit;
      values_[static_cast<std::size_t>(row * kColumns + column)] =
          std::log(overlap({0, ratio * narrow}, {offset, narrow}));
    }
  }
}

const JsdTable& JsdTable::instance() {
  static const JsdTable table;
  return table;
}

double JsdTable::logOverlap(double offset, double log_ratio) const {
  const double column = offset * kPerUnit, row = log_ratio * kPerUnit;
  const int i = std::min(static_cast<int>(row), kRatioNodes - 1);
  const int j = std::min(static_cast<int>(column), kOffsetNodes - 1);
  const auto down = cubicWeights(row - i), across = cubicWeights(column - j);
  const double* at = values_.data() + i * kColumns + j;  // the margin shifts by one node
  double sum = 0;
  for (int k = 0; k < 4; ++k, at += kColumns)
    sum += down[static_cast<std::size_t>(k)] *
           (across[0] * at[0] + across[1] * at[1] + across[2] * at[2] + across[3] * at[3]);
  return sum;
}

Agreement agreement(double mean1, double v1, double mean2, double v2) {
  if (!proper(mean1, v1, mean2, v2)) return {};
  const double offset = std::abs(mean1 - mean2) / std::sqrt(v1 + v2);
  if (!(offset <= JsdTable::kMostOffset)) return {};
  const double log_ratio = std::abs(0.5 * std::log(v1 / v2));
  const double inside = std::min(log_ratio, JsdTable::kMostLogRatio);
  const JsdTable& table = JsdTable::instance();
  const double here = table.logOverlap(offset, inside);
  Agreement a;
  a.affinity = std::clamp(std::exp(here - table.logOverlap(0, inside)), 0.0, 1.0);
  if (log_ratio <= JsdTable::kMostLogRatio) a.jsd = std::clamp(kLog2 - std::exp(here), 0.0, kLog2);
  return a;
}

Agreement agreementNumeric(double mean1, double v1, double mean2, double v2) {
  if (!proper(mean1, v1, mean2, v2)) return {};
  Agreement a;
  a.jsd = jsdNumeric(mean1, v1, mean2, v2);
  const double without_offset = kLog2 - jsdNumeric(mean1, v1, mean1, v2);
  if (without_offset > 0) a.affinity = std::clamp((kLog2 - a.jsd) / without_offset, 0.0, 1.0);
  return a;
}

}  // namespace svoscope
