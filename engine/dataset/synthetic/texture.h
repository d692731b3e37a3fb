// SPDX-License-Identifier: MIT
// A grey texture with mip-maps.
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

namespace svoscope::synthetic {

class Texture {
 public:
  /// `image` is CV_8UC1. `contrast` scales what differs from the mean of the image: 0 is blank.
  explicit Texture(const cv::Mat& image, double contrast = 1);

  int width() const { return levels_[0].cols; }
  int height() const { return levels_[0].rows; }
  /// Trilinear value, grey levels, at texel coordinates of the finest level (texel centres at
  /// integers); `lod` is log2 of the footprint in texels. Clamped at the borders.
  float sample(float x, float y, float lod) const { return offset_ + gain_ * stored(x, y, lod); }

 private:
  float stored(float x, float y, float lod) const;

  std::vector<cv::Mat> levels_;
  float gain_ = 1, offset_ = 0;  ///< applied to samples: a faint texture keeps its grey levels
};

}  // namespace svoscope::synthetic
