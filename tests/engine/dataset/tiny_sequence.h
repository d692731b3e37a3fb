// SPDX-License-Identifier: MIT
// Tiny sequences that the loader tests write themselves.
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "engine/dataset/sequence.h"
#include "tests/support/support.h"

namespace svoscope::test {

const char* const kTinyCamera =
    "cam0:\n  camera_model: pinhole\n  intrinsics: [40.0, 41.0, 15.5, 11.5]\n"
    "  distortion_model: radtan\n  distortion_coeffs: [-0.1, 0.01, 0.0, 0.0]\n"
    "  resolution: [32, 24]\n  rate_hz: 20\n";

/// A 32 x 24 colour image whose grey value tells which one it is.
inline void writeTinyImage(const std::filesystem::path& file, int gray, int width = 32) {
  std::filesystem::create_directories(file.parent_path());
  cv::imwrite(file.string(), cv::Mat(24, width, CV_8UC3, cv::Scalar(gray, gray, gray)));
}

inline void writeFile(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  writeText(file, text);
}

/// Three frames with depth for the second one.
inline void writeTinyTum(const std::filesystem::path& folder) {
  for (int i = 0; i < 3; ++i)
    writeTinyImage(folder / "rgb" / (std::to_string(i) + ".png"), 50 * i + 50);
  writeFile(folder / "rgb.txt",
            "# timestamp filename\n1.0 rgb/0.png\n1.1 rgb/1.png\n1.2 rgb/2.png\n");
  writeFile(folder / "camera.yaml", kTinyCamera);
  writeFile(folder / "groundtruth.txt", "1.2 2 0 0 0 0 0 1\n1.0 1 0 0 0 0 0 1\n");
  std::filesystem::create_directories(folder / "depth");
  cv::imwrite((folder / "depth" / "a.png").string(), cv::Mat(24, 32, CV_16UC1, cv::Scalar(7500)));
  writeFile(folder / "depth.txt", "1.115 depth/a.png\n1.15 depth/none.png\n");
}

/// The error of opening a sequence, or "opened".
inline std::string openingError(const std::filesystem::path& spec) {
  const auto opened = openSequence(spec.string());
  return opened.ok() ? std::string("opened") : opened.error().message();
}

/// Grey level of the first pixel of a frame; -1 if it cannot be read.
inline int grayOf(Sequence& sequence, int index) {
  const auto image = sequence.read(index);
  return image.ok() ? image.value().gray.at<uchar>(0, 0) : -1;
}

}  // namespace svoscope::test
