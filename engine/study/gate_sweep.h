// SPDX-License-Identifier: MIT
// What a gate on the inlier ratio a/(a+b) lets through: wrong fraction against recall, as the gate
// is raised from 0 to 1. Used by the filter lab and the depth study.
#pragma once

#include <optional>
#include <vector>

namespace svoscope {

/// How one seed ended, as seen by an observer who knows the truth.
struct SeedVerdict {
  bool possible = true;    ///< it could have been measured right: counts for recall
  bool converged = false;  ///< sigma fell below the threshold
  bool right = false;      ///< converged, possible, and within the error that counts as right
  double inlier_ratio = 0;
};

struct GatePoint {
  double gate = 0;    ///< accepted: converged with an inlier ratio of at least this
  double recall = 0;  ///< right and accepted / possible
  double wrong = 0;   ///< not right / accepted
};

/// One point per distinct gate at which a right seed is let through, from the strictest on.
std::vector<GatePoint> sweepGate(const std::vector<SeedVerdict>& seeds);

/// Wrong fraction at the strictest gate with at least this recall; none if no gate has it.
std::optional<double> wrongAtRecall(const std::vector<SeedVerdict>& seeds, double recall);

}  // namespace svoscope
