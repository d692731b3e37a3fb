// SPDX-License-Identifier: MIT
// From rendered light to the bytes of an image: illumination steps and sensor noise.
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace svoscope::synthetic {

/// Brightness factor of each frame: constant for 25 frames, then a step by a ratio between
/// 1.3^-light and 1.3^light; stays within 1/1.3..1.3 (for light up to 1). The first piece is 1.
std::vector<float> illumination(int frames, double light, std::uint64_t seed);

/// Steps by exactly `ratio` every 25 frames: 1, ratio, 1, 1 / ratio, 1, ...
std::vector<float> illuminationSteps(int frames, double ratio);

/// CV_8UC1 of a rendered image: times `gain`, plus Gaussian noise of standard deviation `sigma`
/// grey levels that depends on `seed` only, rounded.
cv::Mat expose(const cv::Mat& rendered, float gain, double sigma, std::uint64_t seed);

}  // namespace svoscope::synthetic
