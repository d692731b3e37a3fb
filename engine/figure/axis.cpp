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
  const double raw = span / n, power = std::pow(10, std::floor(std::log10(raw)));
  for (const double m : {1.0, 2.0, 5.0}) {
    if (m * power >= raw * (1 - 1e-9)) return m * power;
  }
  return 10 * power;
}

double Axis::part(double v) const {
  if (log) return (std::log10(v) - std::log10(low)) / (std::log10(high) - std::log10(low));
  return (v - low) / (high - low);
}

std::vector<double> Axis::ticks() const {
  std::vector<double> values;
  if (!log) {
    // Multiples, not sums: no rounding error piles up, and no "-0".
    for (double i = std::ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i)
      values.push_back(i == 0 ? 0.0 : i * step);
    return values;
  }
  const bool between = high / low < 500;
  for (double power = std::pow(10, std::floor(std::log10(low))); power <= high * 1.001;
       power *= 10) {
    for (const double m : {1.0, 2.0, 5.0}) {
      const double v = m * power;
      if (m > 1 && !between) break;
      if (v >= low * 0.999 && v <= high * 1.001) values.push_back(v);
    }
  }
  return values;
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
