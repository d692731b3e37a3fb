// SPDX-License-Identifier: MIT
// How far two Gaussians are apart: Kullback-Leibler and Jensen-Shannon divergences in nats, and the
// affinity w that the JS depth filter is built on (docs/filters.md).
#pragma once

#include <vector>

namespace svoscope {

constexpr double kLog2 = 0.69314718055994530942;

/// KL(N(mean1, variance1) || N(mean2, variance2)), closed form. Infinite where a variance is not
/// positive or a value not finite.
double klGaussian(double mean1, double variance1, double mean2, double variance2);

/// Jensen-Shannon divergence (11)-(13) by the trapezoidal rule on the union of both Gaussians'
/// grids; Gauss-Hermite nodes would miss a narrow peak. The slow reference. In [0, log 2]; log 2
/// where a variance is not positive or a value not finite.
double jsdNumeric(double mean1, double variance1, double mean2, double variance2);

/// How well two Gaussians agree.
struct Agreement {
  double jsd = kLog2;   ///< J, 0 .. log 2
  double affinity = 0;  ///< w = (log 2 - J) / (log 2 - J0), J0: same spreads without offset
};

/// From a table: within 1e-4 nats of jsdNumeric, symmetric in the two Gaussians. Safe to call from
/// any thread; the first call builds the table.
Agreement agreement(double mean1, double variance1, double mean2, double variance2);
/// The same from jsdNumeric.
Agreement agreementNumeric(double mean1, double variance1, double mean2, double variance2);

/// The table behind agreement(). The divergence of two Gaussians depends on two numbers only,
/// d = |mean1 - mean2| / sqrt(variance1 + variance2) and r = log(sigma1 / sigma2), and is even in
/// both. Kept is log(log 2 - J): smooth down to the limit, so that w keeps its relative accuracy
/// there.
class JsdTable {
 public:
  static const JsdTable& instance();

  static constexpr double kMostOffset = 8;     ///< d; beyond it J = log 2 to 1e-6
  static constexpr double kMostLogRatio = 14;  ///< r; beyond it J = log 2 to 1e-5

  /// log(log 2 - J); 0 <= offset <= kMostOffset, 0 <= log_ratio <= kMostLogRatio.
  double logOverlap(double offset, double log_ratio) const;

 private:
  JsdTable();

  std::vector<double> values_;  ///< by log ratio, then offset; one node of margin below, two above
};

}  // namespace svoscope
