// SPDX-License-Identifier: MIT
#include "engine/dataset/synthetic/exposure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/dataset/synthetic/random.h"

namespace svoscope::synthetic {
namespace {

const int kStepFrames = 25;
const int kNoiseBits = 12;

using NoiseTable = std::array<float, 1 << kNoiseBits>;

/// Standard normal numbers, mean and variance corrected to be exact over the table.
NoiseTable makeNoiseTable() {
  NoiseTable table;
  Random random(20130429);
  double sum = 0, squares = 0;
  for (float& value : table) {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - random.uniform(0, 1)));
    value = static_cast<float>(radius * std::cos(2 * M_PI * random.uniform(0, 1)));
    sum += value;
    squares += static_cast<double>(value) * value;
  }
  const double n = static_cast<double>(table.size()), mean = sum / n;
  const double deviation = std::sqrt(squares / n - mean * mean);
  for (float& value : table) value = static_cast<float>((value - mean) / deviation);
  return table;
}

}  // namespace

std::vector<float> illumination(int frames, double light, std::uint64_t seed) {
  std::vector<float> gains(frames, 1.f);
  if (light <= 0) return gains;
  Random random(mixSeed(seed, 0x11));
  const double limit = std::pow(1.3, std::max(1.0, light));
  double gain = 1;
  for (int i = 0; i < frames; ++i) {
    if (i > 0 && i % kStepFrames == 0) {
      // Away from the limit it is close to, by at least a third of the largest step.
      const double ratio = std::pow(1.3, light * random.uniform(0.33, 1));
      const bool up = gain < 0.85 || (gain < 1.15 && random.below(2) == 0);
      gain = std::clamp(up ? gain * ratio : gain / ratio, 1 / limit, limit);
    }
    gains[i] = static_cast<float>(gain);
  }
  return gains;
}

std::vector<float> illuminationSteps(int frames, double ratio) {
  const double cycle[] = {1, ratio, 1, 1 / ratio};
  std::vector<float> gains(frames);
  for (int i = 0; i < frames; ++i) gains[i] = static_cast<float>(cycle[i / kStepFrames % 4]);
  return gains;
}

cv::Mat expose(const cv::Mat& rendered, float gain, double sigma, std::uint64_t seed) {
  static const NoiseTable table = makeNoiseTable();
  cv::Mat image(rendered.size(), CV_8UC1);
  const float s = static_cast<float>(sigma);
  Random random(mixSeed(seed, 0x22));
  std::uint64_t bits = 0;
  int left = 0;
  for (int y = 0; y < image.rows; ++y) {
    const float* in = rendered.ptr<float>(y);
    uchar* out = image.ptr<uchar>(y);
    for (int x = 0; x < image.cols; ++x) {
      if (left == 0) {
        bits = random.next();
        left = 64 / kNoiseBits;
      }
      const float noise = table[bits & ((1 << kNoiseBits) - 1)];
      bits >>= kNoiseBits;
      --left;
      const float value = gain * in[x] + s * noise + 0.5f;
      out[x] = static_cast<uchar>(std::clamp(value, 0.f, 255.f));
    }
  }
  return image;
}

}  // namespace svoscope::synthetic
