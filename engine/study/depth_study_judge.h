// SPDX-License-Identifier: MIT
// Seeds of the depth study and the verdict over them; internal to the study.
#pragma once

#include <vector>

#include "engine/study/depth_study.h"

namespace svoscope {

struct StudySeed {
  Seed seed;
  double true_inverse = 1;  ///< along the ray, 1/m
  int born = 0;             ///< frame of its keyframe
  int converged_after = 0;  ///< measurements; 0: not converged
  int converged_age = 0;    ///< frames
  int outliers = 0;
  std::vector<float> measurement_nees;

  /// As in the engine, but a seed is done when its sigma is small, whatever its inlier ratio: the
  /// gate on the ratio is swept afterwards.
  void apply(const SeedMeasurement& m, const DepthFilterParameters& p);
};

DepthStudyRow judgeSeeds(const std::string& rule, const std::vector<StudySeed>& seeds,
                         const DepthFilterParameters& filter, const DepthStudyOptions& options);

}  // namespace svoscope
