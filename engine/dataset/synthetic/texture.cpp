// SPDX-License-Identifier: MIT
#include "engine/dataset/synthetic/texture.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace svoscope::synthetic {
namespace {

float bilinear(const cv::Mat& image, float x, float y) {
  x = std::clamp(x, 0.f, static_cast<float>(image.cols - 1));
  y = std::clamp(y, 0.f, static_cast<float>(image.rows - 1));
  const int x0 = std::min(static_cast<int>(x), std::max(0, image.cols - 2));
  const int y0 = std::min(static_cast<int>(y), std::max(0, image.rows - 2));
  const float ax = x - static_cast<float>(x0), ay = y - static_cast<float>(y0);
  const size_t right = image.cols > 1 ? 1 : 0, down = image.rows > 1 ? image.step[0] : 0;
  const uchar* p = image.data + y0 * image.step[0] + x0;
  const float top = static_cast<float>(p[0]) + ax * static_cast<float>(p[right] - p[0]);
  const float bottom =
      static_cast<float>(p[down]) + ax * static_cast<float>(p[down + right] - p[down]);
  return top + ay * (bottom - top);
}

}  // namespace

Texture::Texture(const cv::Mat& image, double contrast) : gain_(static_cast<float>(contrast)) {
  if (contrast != 1) offset_ = static_cast<float>((1 - contrast) * cv::mean(image)[0]);
  levels_.push_back(image);
  while (std::min(levels_.back().cols, levels_.back().rows) >= 2) {
    // Exact halves only: an odd row or column is dropped, so that level l is level 0 shrunk by
    // exactly 2^l and sample() needs no scale of its own for each level.
    const cv::Mat& fine = levels_.back();
    const cv::Mat even = fine(cv::Rect(0, 0, fine.cols / 2 * 2, fine.rows / 2 * 2));
    cv::Mat coarse;
    cv::resize(even, coarse, cv::Size(even.cols / 2, even.rows / 2), 0, 0, cv::INTER_AREA);
    levels_.push_back(coarse);
  }
}

float Texture::stored(float x, float y, float lod) const {
  if (lod <= 0.f) return bilinear(levels_[0], x, y);
  const int last = static_cast<int>(levels_.size()) - 1;
  const int level = std::min(static_cast<int>(lod), last);
  const float fraction = level == last ? 0.f : lod - static_cast<float>(level);
  // Texel centres: x_l + 0.5 = (x + 0.5) / 2^l.
  const float s = 1.f / static_cast<float>(1 << level);
  const float xl = (x + 0.5f) * s, yl = (y + 0.5f) * s;
  const float fine = bilinear(levels_[level], xl - 0.5f, yl - 0.5f);
  if (fraction <= 0.f) return fine;
  const float coarse = bilinear(levels_[level + 1], 0.5f * xl - 0.5f, 0.5f * yl - 0.5f);
  return fine + fraction * (coarse - fine);
}

}  // namespace svoscope::synthetic
