// SPDX-License-Identifier: MIT
#include "engine/figure/axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace svoscope {

namespace {

/// 1, 2 or 5 times a power of ten at or below (`up`: above) v > 0.
double niceBound(double v, bool up) {
  const double power = std::pow(10, std::floor(std::log10(v)));
  double best = power;
  for (const double m : {1.0, 2.0, 5.0, 10.0}) {
    if (up && m * power >= v * (1 - 1e-9)) return m * power;
    if (m * power <= v * (1 + 1e-9)) best = m * power;
  }
  return best;
}

}  // namespace

double niceStep(double span, int n) {
  if (!(span > 0) || !std::isfinite(span)) return 1;
  const double raw = span / std::max(1, n), power = std::pow(10, std::floor(std::log10(raw)));
  for (const double m : {1.0, 2.0, 5.0}) {
    if (m * power >= raw * (1 - 1e-9)) return m * power;
  }
  return 10 * power;
}

std::vector<double> linearTicks(double low, double high, double step) {
  constexpr std::size_t kMost = 1000;  // a range far from zero, too narrow for doubles
  std::vector<double> ticks;
  // Multiples, not sums: no rounding error piles up, and no "-0".
  for (double i = std::ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; i += 1) {
    ticks.push_back(i == 0 ? 0.0 : i * step);
    if (ticks.size() > kMost) break;
  }
  return ticks;
}

std::vector<double> decadeTicks(double low, double high, const std::vector<double>& factors) {
  std::vector<double> ticks;
  for (double e = std::floor(std::log10(low)); e <= std::log10(high) + 1e-9; e += 1) {
    for (const double factor : factors) {
      const double tick = factor * std::pow(10.0, e);
      if (tick >= low * (1 - 1e-9) && tick <= high * (1 + 1e-9)) ticks.push_back(tick);
    }
  }
  return ticks;
}

double Axis::part(double v) const {
  if (log) return (std::log10(v) - std::log10(low)) / (std::log10(high) - std::log10(low));
  return (v - low) / (high - low);
}

std::vector<double> Axis::ticks() const {
  if (!log) return linearTicks(low, high, step);
  const bool few = high / low < 500;
  return decadeTicks(low, high, few ? std::vector<double>{1, 2, 5} : std::vector<double>{1});
}

Axis fitAxis(const std::vector<double>& values, bool log, bool from_zero, AxisFit fit, int steps) {
  double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
  for (const double v : values) {
    if (!std::isfinite(v) || (log && v <= 0)) continue;
    low = std::min(low, v);
    high = std::max(high, v);
  }
  if (low > high) low = log ? 0.1 : 0, high = 1;  // nothing to show
  Axis axis;
  axis.log = log;
  if (log) {
    axis.low = niceBound(low, false);
    axis.high = std::max(niceBound(high, true), 2 * axis.low);
    return axis;
  }
  if (from_zero) low = std::min(low, 0.0);
  if (!(high - low > 1e-12)) high = low + 1;
  axis.step = niceStep(high - low, steps);
  const double margin = 0.04 * (high - low);
  axis.low = fit == AxisFit::tight ? low - margin : std::floor(low / axis.step + 1e-9) * axis.step;
  axis.high =
      fit == AxisFit::tight ? high + margin : std::ceil(high / axis.step - 1e-9) * axis.step;
  return axis;
}

std::string tickText(double value) { return fmt::format("{:.4g}", value); }

}  // namespace svoscope
