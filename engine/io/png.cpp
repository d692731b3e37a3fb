// SPDX-License-Identifier: MIT
#include "engine/io/png.h"

#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "engine/io/text_output.h"

namespace svoscope {

Status writePng(const std::filesystem::path& file, const cv::Mat& image) {
  const int type = image.empty() ? -1 : image.type();
  if (type != CV_8UC1 && type != CV_8UC3 && type != CV_8UC4 && type != CV_16UC1) {
    return Error{ErrorKind::internal, "an image of this type cannot be a PNG", file.string(), ""};
  }
  // Encoded in memory: cv::imwrite does not notice a full disk.
  std::vector<unsigned char> bytes;
  // OpenCV's default is fast and twice as large.
  const std::vector<int> settings = {cv::IMWRITE_PNG_COMPRESSION, 6, cv::IMWRITE_PNG_STRATEGY,
                                     cv::IMWRITE_PNG_STRATEGY_DEFAULT};
  if (!cv::imencode(".png", image, bytes, settings)) {
    return Error{ErrorKind::internal, "the PNG encoder failed", file.string(), ""};
  }
  return writeWhole(file, std::string(bytes.begin(), bytes.end()));
}

}  // namespace svoscope
