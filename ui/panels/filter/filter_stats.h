// SPDX-License-Identifier: MIT
// How the rules of the depth filter differ over all updates: read snapshot by snapshot, kept in
// fixed space.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "engine/runner/run_view.h"

namespace svoscope::ui {

/// Equal bins of a value or of its decimal logarithm; what lies outside counts in the end bins.
class Bins {
 public:
  Bins(double lo, double hi, int count, bool log)
      : lo_(lo), hi_(hi), log_(log), counts_(static_cast<std::size_t>(count)) {}
  void add(double value);  ///< NaN is left out
  void clear();
  int total() const { return total_; }
  double lo() const { return lo_; }
  double hi() const { return hi_; }
  bool log() const { return log_; }
  const std::vector<int>& counts() const { return counts_; }
  double edge(int i) const;         ///< lower edge of bin i
  double quantile(double q) const;  ///< interpolated within the bin; NaN if empty

 private:
  double lo_, hi_;
  bool log_;
  std::vector<int> counts_;
  int total_ = 0;
};

/// One measurement and what it did; enough for scatter, brush and errors.
struct UpdatePoint {
  std::int64_t seed_id = -1;
  int frame = -1;                ///< of the snapshot
  float kl = 0, kl_reverse = 0;  ///< KL(belief || measurement), KL(measurement || belief), nats
  float jsd = 0, affinity = 0;
  ByRule<float> mu, sigma, ratio;  ///< after; sigma 0: not computed
  float true_inv_distance = 0;     ///< metres; 0 if unknown
};

/// Distributions of one scope: the run so far, or one frame.
struct FilterDistributions {
  FilterDistributions();
  Bins kl, kl_reverse, jsd, affinity;
  Bins sigma_ratio;  ///< of the second rule of the table over the first
  ByRule<Bins> ratio;
  void add(const UpdatePoint& point);
  void clear();
};

class FilterStats {
 public:
  static constexpr std::size_t kMostPoints = 6000;  ///< newest measurements kept one by one
  static constexpr int kMostUpdates = 120;          ///< of the convergence curves
  static constexpr int kSnapshotsPerCall = 120;  ///< so that catching up does not stall the window

  /// Reads snapshots that are new; starts again after a reset. True if nothing is left to read.
  bool update(const RunView& run, const SnapshotPtr& latest);

  const FilterDistributions& run() const { return run_; }
  const std::deque<UpdatePoint>& points() const { return points_; }
  int measurements() const { return measurements_; }  ///< read so far
  int next() const { return next_; }                  ///< frame to be read next
  int first() const { return first_; }                ///< oldest frame that was read
  std::uint64_t version() const { return version_; }

  /// Quantile of sigma / R by number of measurements (from 1), of all seeds read; NaN below 5
  /// seeds.
  std::vector<float> convergence(FilterRule rule, double q) const;
  int seedsWith(int updates) const;

 private:
  void read(const Snapshot& snapshot);

  int generation_ = -1, next_ = 0, first_ = -1, measurements_ = 0;
  std::uint64_t version_ = 0;
  FilterDistributions run_;
  std::deque<UpdatePoint> points_;
  ByRule<std::vector<Bins>> by_updates_;
};

/// The measurements of one snapshot.
std::vector<UpdatePoint> pointsOf(const Snapshot& snapshot);

/// Seeds whose points lie in a rectangle of the scatter.
std::vector<std::int64_t> brushed(const std::vector<UpdatePoint>& points, double kl_lo,
                                  double kl_hi, double jsd_lo, double jsd_hi);

/// Errors against the truth, by rule. `scale`: metres per map unit.
struct Calibration {
  int count = 0;
  ByRule<std::vector<float>> share;  ///< of errors within ...
  std::vector<float>
      expected;  ///< ... as many standard deviations as cover this share of a Gaussian
  ByRule<std::vector<float>> error;  ///< sorted relative distance errors
  ByRule<double> median_nees, median_error;
};
Calibration calibrate(const std::vector<UpdatePoint>& points, double scale);

std::string statsCsv(const std::vector<UpdatePoint>& points);

}  // namespace svoscope::ui
