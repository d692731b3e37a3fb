// SPDX-License-Identifier: MIT
// The arithmetic of plots: ranges, ticks, data <-> pixel, and thinning that keeps peaks.
#pragma once

#include <imgui/imgui.h>

#include <string>
#include <vector>

#include "engine/figure/axis.h"  // niceStep: the step that linearTicks uses

namespace svoscope::ui {

struct Range {
  double lo = 0, hi = 1;
  double span() const { return hi - lo; }
  bool contains(double v) const { return v >= lo && v <= hi; }
};

/// Multiples of 1, 2 or 5 times a power of ten inside the range, at most `max_count` of them.
std::vector<double> linearTicks(Range range, int max_count);
/// Powers of ten inside the range, thinned to `max_count`; if there are fewer than three, also 2
/// and 5 times them, or every multiple; in a range so narrow that a log axis is nearly linear,
/// linear ticks.
std::vector<double> logTicks(Range range, int max_count);
/// Shortest text that tells neighbouring ticks apart; "k" and "M" for thousands and millions.
std::string tickLabel(double value, double step);
/// The same on a log axis, where every tick has a step of its own.
std::string logTickLabel(double value);

/// Smallest range around the finite values (positive ones only for a log axis); lo > hi if none.
Range finiteRange(const float* values, int count, bool positive_only);
/// Room around data; a degenerate or empty range becomes a usable one.
Range padded(Range range, double fraction, bool log);
/// Scales about `center` by `factor`; on a log axis in decades.
Range zoomed(Range range, double center, double factor, bool log);
Range shifted(Range range, double fraction, bool log);

/// Linear or logarithmic axis: data -> pixel and back.
struct Axis {
  Range data;
  float px_lo = 0, px_hi = 1;  ///< pixels of data.lo and data.hi (px_hi < px_lo for an upward y)
  bool log = false;

  float toPixel(double value) const;
  double toData(float px) const;
};

/// Runs of points to be joined by lines, in pixels. Runs break at NaN. If there are more samples
/// than pixel columns, each column keeps its first, lowest, highest and last sample: no peak is
/// lost.
std::vector<std::vector<ImVec2>> buildRuns(const float* x, const float* y, int count,
                                           const Axis& x_axis, const Axis& y_axis);

}  // namespace svoscope::ui
