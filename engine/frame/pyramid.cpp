// SPDX-License-Identifier: MIT
#include "engine/frame/pyramid.h"

#include <algorithm>

namespace svoscope {

namespace {
constexpr int kSmallestSide = 14;
}

cv::Mat halfSample(const cv::Mat& image) {
  const int w = image.cols / 2, h = image.rows / 2;
  cv::Mat half(h, w, CV_8UC1);
  for (int y = 0; y < h; ++y) {
    const std::uint8_t* __restrict top = image.ptr<std::uint8_t>(2 * y);
    const std::uint8_t* __restrict bottom = image.ptr<std::uint8_t>(2 * y + 1);
    std::uint8_t* __restrict out = half.ptr<std::uint8_t>(y);
    for (int x = 0; x < w; ++x) {
      const unsigned sum = top[2 * x] + top[2 * x + 1] + bottom[2 * x] + bottom[2 * x + 1];
      out[x] = static_cast<std::uint8_t>((sum + 2) >> 2);
    }
  }
  return half;
}

PyramidPtr buildPyramid(const cv::Mat& image, int levels) {
  auto pyramid = std::make_shared<Pyramid>();
  pyramid->push_back(image);
  while (static_cast<int>(pyramid->size()) < levels) {
    const cv::Mat& last = pyramid->back();
    if (std::min(last.cols, last.rows) / 2 < kSmallestSide) break;
    pyramid->push_back(halfSample(last));
  }
  return pyramid;
}

int pyramidLevels(int width) {
  return std::clamp(5 + static_cast<int>(std::lround(std::log2(std::max(width, 1) / 640.0))), 3, 7);
}

}  // namespace svoscope
