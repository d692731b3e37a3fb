// SPDX-License-Identifier: MIT
// Range and ticks of a chart's axis.
#pragma once

#include <string>
#include <vector>

namespace svoscope {

struct Axis {
  double low = 0, high = 1;
  double step = 0.2;  ///< between ticks of a linear axis
  bool log = false;

  /// 0 at `low`, 1 at `high`; not clamped. A logarithmic axis wants v > 0.
  double part(double v) const;
  /// Round values from low to high; on a logarithmic axis powers of ten, and 2 and 5 times these
  /// where there are few.
  std::vector<double> ticks() const;
};

enum class AxisFit {
  round,  ///< out to the next ticks
  tight,  ///< the values with a small margin
};

/// Axis over all finite values (positive ones if `log`); [0, 1] or [0.1, 1] without any.
Axis fitAxis(const std::vector<double>& values, bool log, bool from_zero,
             AxisFit fit = AxisFit::round, int steps = 6);

/// 1, 2 or 5 times a power of ten, so that a span has about `n` steps or fewer; 1 for a span that
/// is not positive and finite.
double niceStep(double span, int n);

/// Multiples of `step` from low to high.
std::vector<double> linearTicks(double low, double high, double step);
/// `factors` (rising, 1 to below 10) times powers of ten from low > 0 to high, rising.
std::vector<double> decadeTicks(double low, double high, const std::vector<double>& factors);

/// A tick's value as short as can be: "0", "0.02", "1500".
std::string tickText(double value);

}  // namespace svoscope
