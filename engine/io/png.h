// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>

#include "engine/base/result.h"

namespace svoscope {

/// Writes CV_8UC1, CV_8UC3 (BGR), CV_8UC4 (BGRA) or CV_16UC1 as PNG, whole or not at all. Output
/// error naming the file; internal error for an empty image or another type.
Status writePng(const std::filesystem::path& file, const cv::Mat& image);

}  // namespace svoscope
