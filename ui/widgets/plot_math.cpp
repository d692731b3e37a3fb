// SPDX-License-Identifier: MIT
#include "ui/widgets/plot_math.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace svoscope::ui {

namespace {

constexpr double kSmallest = 1e-12;  // positive floor of a log axis

double logOf(double v) { return std::log10(std::max(v, kSmallest)); }

}  // namespace

std::vector<double> linearTicks(Range range, int max_count) {
  if (!(range.span() > 0) || !std::isfinite(range.span()) || max_count < 1) return {};
  return svoscope::linearTicks(range.lo, range.hi, niceStep(range.span(), max_count));
}

namespace {

/// Multiples of the powers of ten inside the range, rising.
std::vector<double> multiples(Range range, const std::vector<double>& factors) {
  return decadeTicks(std::max(range.lo, kSmallest), range.hi, factors);
}

std::vector<double> thinned(const std::vector<double>& ticks, int max_count) {
  const std::size_t most = static_cast<std::size_t>(std::max(1, max_count));
  const std::size_t step = (ticks.size() + most - 1) / most;
  std::vector<double> kept;
  for (std::size_t i = 0; i < ticks.size(); i += step) kept.push_back(ticks[i]);
  return kept;
}

}  // namespace

std::vector<double> logTicks(Range range, int max_count) {
  constexpr double kNarrow = 4;  // hi over lo below which multiples leave one side of 1 bare
  constexpr std::size_t kEnough = 3;
  if (!(range.lo > 0) || !std::isfinite(range.hi)) return {};
  if (range.hi < kNarrow * range.lo) return linearTicks(range, max_count);
  std::vector<double> ticks = thinned(multiples(range, {1}), max_count);
  for (const auto& factors :
       {std::vector<double>{1, 2, 5}, std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9}}) {
    if (ticks.size() >= kEnough) break;
    const auto finer = multiples(range, factors);
    if (finer.size() > ticks.size() && static_cast<int>(finer.size()) <= std::max(2, max_count))
      ticks = finer;
  }
  return ticks;
}

std::string tickLabel(double value, double step) {
  char text[32];
  const double magnitude = std::abs(value);
  if (magnitude >= 1e6 || (magnitude > 0 && magnitude < 1e-3 && step < 1e-3)) {
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
  }
  if (magnitude >= 1e4 && step >= 100) {
    std::snprintf(text, sizeof text, "%.4gk", value / 1e3);
    return text;
  }
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 6);
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

std::string logTickLabel(double value) {
  char text[32];
  if (value <= 0 || (value > 0.9e-3 && value < 9.9e3)) {
    std::snprintf(text, sizeof text, "%.4g", value);
  } else {
    const double exponent = std::floor(std::log10(value) + 1e-9);
    std::snprintf(text, sizeof text, "%.3ge%.0f", value / std::pow(10.0, exponent), exponent);
  }
  return text;
}

Range finiteRange(const float* values, int count, bool positive_only) {
  Range r{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (int i = 0; i < count; ++i) {
    const double v = values[i];
    if (!std::isfinite(v) || (positive_only && v <= 0)) continue;
    r.lo = std::min(r.lo, v);
    r.hi = std::max(r.hi, v);
  }
  return r;
}

Range padded(Range range, double fraction, bool log) {
  if (!(range.lo <= range.hi)) return log ? Range{0.1, 10} : Range{0, 1};
  if (log) {
    const double lo = logOf(range.lo), hi = logOf(range.hi);
    const double pad = std::max((hi - lo) * fraction, 0.1);
    return {std::pow(10.0, lo - pad), std::pow(10.0, hi + pad)};
  }
  if (range.span() <= 1e-9 * std::max(1.0, std::abs(range.hi))) {
    const double half = std::max(0.5 * std::abs(range.hi), 0.5);
    return {range.lo - half, range.hi + half};
  }
  return {range.lo - fraction * range.span(), range.hi + fraction * range.span()};
}

Range zoomed(Range range, double center, double factor, bool log) {
  if (log) {
    const double c = logOf(center), lo = logOf(range.lo), hi = logOf(range.hi);
    return {std::pow(10.0, c + (lo - c) * factor), std::pow(10.0, c + (hi - c) * factor)};
  }
  return {center + (range.lo - center) * factor, center + (range.hi - center) * factor};
}

Range shifted(Range range, double fraction, bool log) {
  if (log) {
    const double by = std::pow(10.0, (logOf(range.hi) - logOf(range.lo)) * fraction);
    return {range.lo * by, range.hi * by};
  }
  const double by = range.span() * fraction;
  return {range.lo + by, range.hi + by};
}

float Axis::toPixel(double value) const {
  const double lo = log ? logOf(data.lo) : data.lo, hi = log ? logOf(data.hi) : data.hi;
  const double v = log ? logOf(value) : value;
  const double t = hi > lo ? (v - lo) / (hi - lo) : 0.5;
  // Far outside is as good as outside: keeps the numbers within float and int ranges.
  return px_lo + static_cast<float>(std::clamp(t, -100.0, 100.0)) * (px_hi - px_lo);
}

double Axis::toData(float px) const {
  const double t = px_hi != px_lo ? (px - px_lo) / (px_hi - px_lo) : 0.5;
  if (!log) return data.lo + t * data.span();
  const double lo = logOf(data.lo), hi = logOf(data.hi);
  return std::pow(10.0, lo + t * (hi - lo));
}

namespace {

struct Column {
  int x = 0;
  ImVec2 first, low, high, last;

  void start(int column, ImVec2 p) {
    x = column;
    first = low = high = last = p;
  }
  void add(ImVec2 p) {
    if (p.y > low.y) low = p;  // pixels grow downwards
    if (p.y < high.y) high = p;
    last = p;
  }
  void flush(std::vector<ImVec2>& run) const {
    run.push_back(first);
    if (low.y != first.y) run.push_back({first.x, low.y});
    if (high.y != low.y) run.push_back({first.x, high.y});
    if (last.y != high.y) run.push_back({first.x, last.y});
  }
};

std::vector<ImVec2> thinned(const std::vector<ImVec2>& run) {
  std::vector<ImVec2> out;
  Column column;
  for (std::size_t i = 0; i < run.size(); ++i) {
    const int x = static_cast<int>(std::floor(run[i].x));
    if (i == 0) {
      column.start(x, run[i]);
    } else if (x == column.x) {
      column.add(run[i]);
    } else {
      column.flush(out);
      column.start(x, run[i]);
    }
  }
  if (!run.empty()) column.flush(out);
  return out;
}

}  // namespace

std::vector<std::vector<ImVec2>> buildRuns(const float* x, const float* y, int count,
                                           const Axis& x_axis, const Axis& y_axis) {
  std::vector<std::vector<ImVec2>> runs;
  // One sample beyond either end, so that lines leave the plot instead of ending inside.
  const float* begin = std::lower_bound(x, x + count, static_cast<float>(x_axis.data.lo));
  const float* end = std::upper_bound(x, x + count, static_cast<float>(x_axis.data.hi));
  const int first = std::max(0, static_cast<int>(begin - x) - 1);
  const int last = std::min(count, static_cast<int>(end - x) + 1);
  bool open = false;
  for (int i = first; i < last; ++i) {
    const bool usable = std::isfinite(y[i]) && !(y_axis.log && y[i] <= 0);
    if (usable && !open) runs.emplace_back();
    open = usable;
    if (usable) runs.back().push_back({x_axis.toPixel(x[i]), y_axis.toPixel(y[i])});
  }
  const auto columns = static_cast<int>(std::abs(x_axis.px_hi - x_axis.px_lo));
  if (last - first > columns) {
    for (auto& run : runs) run = thinned(run);
  }
  return runs;
}

}  // namespace svoscope::ui
