// SPDX-License-Identifier: MIT
// Features to start from: corners spread over a grid and, where there are none, edge points.
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "engine/base/kinds.h"
#include "engine/base/types.h"

namespace svoscope {

struct StartFeature {
  Vec2 px = Vec2::Zero();  ///< level 0
  int level = 0;           ///< pyramid level it was found at
  FeatureType type = FeatureType::corner;
  double score = 0;                  ///< grey levels per px: gradient in the weaker direction
                                     ///< (corner) or across the edge (edgelet)
  Vec2 gradient_dir = Vec2::Zero();  ///< unit vector; of an edgelet across the edge
};

/// One feature per cell. Thresholds are lowered and cells made smaller, in steps, while fewer
/// than `wanted` corners are found, so that a weakly textured scene still gives what it has.
std::vector<StartFeature> detectStartFeatures(const std::vector<cv::Mat>& pyramid, int wanted);

}  // namespace svoscope
