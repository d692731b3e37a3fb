// SPDX-License-Identifier: MIT
// The filter lab: a population of simulated seeds under every variant of rule_variants.h
// (docs/filters.md). Nothing but the filter is simulated, so the truth is known exactly.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/study/gate_sweep.h"

namespace svoscope {

struct LabOptions {
  int seeds = 4000;
  int updates = 60;          ///< frames in which a seed is measured
  double outliers = 0.2;     ///< measurements that fall anywhere in the search window
  double hopeless = 0.2;     ///< seeds that never see a right measurement
  double noise = 0.4;        ///< standard deviation of a right measurement, in tau
  double search_sigmas = 3;  ///< half width of the search window, in sigma
  double step_m = 0.01;      ///< baseline gained per frame, up to 40 frames
  double focal_px = 525;
  double mean_depth_m = 2, min_depth_m = 1;  ///< depths uniform in [min, 2 mean - min]
  double converged_fraction = 1.0 / 200;     ///< converged when sigma < R * this, R = 1 / min depth
  double right_error = 0.05;                 ///< relative depth error up to which a seed is right
  std::uint64_t random_seed = 0;

  /// Empty, or which value is out of bounds and what is allowed.
  std::string check() const;
};

/// Over the seeds that are not hopeless, after each update; a converged seed is left as it is.
struct LabCurvePoint {
  int update = 0;
  double median_error = 0;  ///< |mu - true inverse depth|, 1/m
  double median_sigma = 0;  ///< 1/m
  double converged = 0;     ///< fraction
};

struct LabRow {
  std::string rule;                                ///< name of its RuleVariant
  std::optional<double> median_updates;            ///< to converge, of the right seeds
  std::optional<double> median_relative_error;     ///< of the depth, right seeds
  std::optional<double> p90_relative_error;        ///< converged seeds that are not hopeless
  std::optional<double> wrong_at_80, wrong_at_60;  ///< wrong fraction at recall 0.8, 0.6
  std::optional<double> median_nees;  ///< (error / sigma)^2 of the right seeds; calibrated: 0.455
  double converged = 0;               ///< of all seeds
  double hopeless_converged = 0;      ///< of the hopeless seeds
  std::vector<GatePoint> sweep;
  std::vector<LabCurvePoint> curve;
};

struct LabResult {
  LabOptions options;
  std::vector<LabRow> rows;  ///< in the order of ruleVariants()
};

/// Deterministic: the same options give the same result. About 0.1 ms per seed at the defaults.
LabResult runLab(const LabOptions& options);

/// Two Gaussians and everything said about them, for the lab's first picture.
struct LabPair {
  double kl_pq = 0, kl_qp = 0;  ///< nats, closed form
  double jsd = 0, affinity = 0;
};
LabPair comparePair(double mean_p, double sigma_p, double mean_q, double sigma_q);

}  // namespace svoscope
