// SPDX-License-Identifier: MIT
// Intervals by resampling (Efron & Tibshirani, An Introduction to the Bootstrap, 1993, ch. 13).
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

/// Percentile interval of the mean. Empty values give [0, 0], one value [v, v].
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

/// Percentile interval of the mean difference. Groups are drawn with replacement, and within a
/// group the runs of a and of b: both the choice of sequences and the spread of runs count.
PairedDifference bootstrapPaired(const std::vector<PairedGroup>& groups,
                                 const BootstrapOptions& options = {});

double meanOf(const std::vector<double>& values);  ///< 0 if empty

}  // namespace svoscope
