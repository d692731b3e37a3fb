// SPDX-License-Identifier: MIT
// Sub-pixel alignment of an 8x8 patch by inverse compositional Lucas-Kanade (Baker & Matthews,
// IJCV 2004) with a brightness gain and offset per patch.
#pragma once

#include <opencv2/core/mat.hpp>

#include "engine/match/patch.h"

namespace svoscope {

struct FeatureAlignmentParameters {
  int max_iterations = 10;
  double min_step_px = 0.03;   ///< converged below
  double max_mean_error = 22;  ///< refused above: RMS residual after alignment, grey levels
  bool estimate_gain = true;   ///< besides the offset
};

struct AlignmentResult {
  bool converged = false;
  Vec2 px = Vec2::Zero();  ///< on the level searched
  double rms = 0;          ///< grey levels, gain and offset removed
  int iterations = 0;
};

/// Aligns in both directions. `px` is the start, on the level of `image`.
AlignmentResult alignPatch2D(const cv::Mat& image, const WarpedPatch& patch, const Vec2& px,
                             const FeatureAlignmentParameters& parameters);

/// Aligns along the unit vector `direction` (level pixels) only.
AlignmentResult alignPatch1D(const cv::Mat& image, const WarpedPatch& patch, const Vec2& px,
                             const Vec2& direction, const FeatureAlignmentParameters& parameters);

}  // namespace svoscope
