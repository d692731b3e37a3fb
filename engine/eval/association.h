// SPDX-License-Identifier: MIT
// Which pose of the estimate belongs to which pose of the ground truth.
#pragma once

#include <vector>

#include "engine/base/result.h"
#include "engine/geometry/trajectory.h"

namespace svoscope {

struct PosePair {
  int gt = 0;   ///< index into the ground truth
  int est = 0;  ///< index into the estimate
};

/// For each pose of the shorter trajectory the nearest in time of the longer one (the estimate
/// counts as shorter on a tie), kept if not more than `max_dt` seconds away. A pose of the longer
/// trajectory may serve twice. Both must be sorted by time. Input error if nothing matches.
Result<std::vector<PosePair>> associateByTime(const Trajectory& gt, const Trajectory& est,
                                              double max_dt);

/// Row i with row i. Input error unless both have the same number of rows.
Result<std::vector<PosePair>> associateByRow(const Trajectory& gt, const Trajectory& est);

}  // namespace svoscope
