// SPDX-License-Identifier: MIT
// Image pyramid by half-sampling. Level 0 is the rectified image; a pixel of level L+1 is the mean
// of 2x2 pixels of level L, an odd last column or row is dropped (never sheared).
#pragma once

#include <cmath>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "engine/base/types.h"

namespace svoscope {

using Pyramid = std::vector<cv::Mat>;  ///< CV_8UC1 each
using PyramidPtr = std::shared_ptr<const Pyramid>;

/// 2x2 mean, rounded, of a CV_8UC1 image; size (w / 2, h / 2) rounded down.
cv::Mat halfSample(const cv::Mat& image);

/// Builds at most `levels` levels; stops before the shorter side falls below 14 px.
PyramidPtr buildPyramid(const cv::Mat& image, int levels);

/// Levels wanted for an image width: 5 at 640, one more per doubling.
int pyramidLevels(int width);

/// Pixel coordinates between level 0 and level L. Pixel centres are integers on every level, so
/// the 2x2 mean shifts them by half a pixel per halving.
inline Vec2 toLevel(const Vec2& px0, int level) {
  const double s = 1.0 / (1 << level);
  return {(px0.x() + 0.5) * s - 0.5, (px0.y() + 0.5) * s - 0.5};
}
inline Vec2 fromLevel(const Vec2& px, int level) {
  const double s = 1 << level;
  return {(px.x() + 0.5) * s - 0.5, (px.y() + 0.5) * s - 0.5};
}

}  // namespace svoscope
