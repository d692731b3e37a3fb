// SPDX-License-Identifier: MIT
// A grey texture with mip-maps.
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

namespace svoscope::synthetic {

class Texture {
 public:
  /// `image` is CV_8UC1.
  explicit Texture(const cv::Mat& image);

  int width() const { return levels_[0].cols; }
  int height() const { return levels_[0].rows; }
  /// Trilinear value, grey levels, at texel coordinates of the finest level (texel centres at
  /// integers); `lod` is log2 of the footprint in texels. Clamped at the borders.
  float sample(float x, float y, float lod) const;

 private:
  std::vector<cv::Mat> levels_;
};

}  // namespace svoscope::synthetic
