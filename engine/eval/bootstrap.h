// SPDX-License-Identifier: MIT
// Intervals by resampling (Efron & Tibshirani, An Introduction to the Bootstrap, 1993, ch. 13),
// expanded for few values (Hesterberg, What Teachers Should Know about the Bootstrap, 2015,
// sec. 3.2): plain percentile intervals of six values miss the truth more than twice as often as
// they say.
#pragma once

#include <cstdint>
#include <vector>

namespace svoscope {

struct Interval {
  double low = 0, high = 0;
};

struct BootstrapOptions {
  double level = 0.95;
  int resamples = 10000;
  std::uint64_t seed = 1;  ///< the same values give the same interval
};

/// Expanded percentile interval of the mean. Empty values give [0, 0], one value [v, v].
Interval bootstrapMean(const std::vector<double>& values, const BootstrapOptions& options = {});

/// What two methods gave on one sequence, a value for each run.
struct PairedGroup {
  std::vector<double> a, b;  ///< neither may be empty
};

struct PairedDifference {
  double mean = 0;  ///< over groups of mean(a) - mean(b)
  Interval interval;
  int groups = 0;
};

/// Expanded percentile interval of the mean difference, for as many values as there are groups, or
/// runs if it is one group. Groups are drawn with replacement, and within a group the runs of a and
/// of b: both the choice of sequences and the spread of runs count.
PairedDifference bootstrapPaired(const std::vector<PairedGroup>& groups,
                                 const BootstrapOptions& options = {});

/// Quantile of Student's t distribution, by numerical integration; `fraction` in (0.5, 1).
double studentQuantile(double fraction, int degrees_of_freedom);

double meanOf(const std::vector<double>& values);  ///< 0 if empty

}  // namespace svoscope
