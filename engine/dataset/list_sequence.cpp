// SPDX-License-Identifier: MIT
#include "engine/dataset/list_sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string_view>

#include "engine/base/quantile.h"
#include "engine/dataset/exif.h"

namespace svoscope {
namespace {

namespace fs = std::filesystem;

const char* const kCopyAgain = "copy or extract the sequence again";

std::string sizeText(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

std::string lowerExtension(const fs::path& file) {
  std::string text = file.extension().string();
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return text;
}

/// PNG and JPEG state their end; other formats are left to the decoder.
bool endIsMissing(std::string_view bytes) {
  const std::string_view tail = bytes.substr(bytes.size() - std::min<size_t>(bytes.size(), 4096));
  if (bytes.substr(0, 4) == "\x89PNG") return tail.find("IEND") == std::string_view::npos;
  if (bytes.substr(0, 2) == "\xFF\xD8") return tail.find("\xFF\xD9") == std::string_view::npos;
  return false;
}

/// Compares runs of digits as numbers.
bool naturalLess(const std::string& a, const std::string& b) {
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (digit(a[i]) && digit(b[j])) {
      size_t m = i, n = j;
      while (m < a.size() && digit(a[m])) ++m;
      while (n < b.size() && digit(b[n])) ++n;
      while (i < m && a[i] == '0') ++i;
      while (j < n && b[j] == '0') ++j;
      if (m - i != n - j) return m - i < n - j;
      const int order = a.compare(i, m - i, b, j, n - j);
      if (order != 0) return order < 0;
      i = m;
      j = n;
    } else {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i;
      ++j;
    }
  }
  if (a.size() - i != b.size() - j) return a.size() - i < b.size() - j;
  return a < b;
}

}  // namespace

Result<std::string> readImageBytes(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in)
    return inputError("the image is missing", file.string(),
                      "restore the file or remove it from the list");
  std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (bytes.empty()) return inputError("the image file is empty", file.string(), kCopyAgain);
  if (endIsMissing(bytes)) return inputError("the image is truncated", file.string(), kCopyAgain);
  return bytes;
}

Result<cv::Mat> readImageFile(const fs::path& file, int flags) {
  const auto read = readImageBytes(file);
  if (!read) return read.error();
  const std::string& bytes = read.value();
  cv::Mat image;
  try {
    const cv::Mat raw(1, static_cast<int>(bytes.size()), CV_8UC1, const_cast<char*>(bytes.data()));
    image = cv::imdecode(raw, flags);
  } catch (const cv::Exception&) {
    image.release();
  }
  if (image.empty()) return inputError("the image cannot be decoded", file.string(), kCopyAgain);
  return image;
}

std::vector<fs::path> sortedImages(const fs::path& folder) {
  static const char* const kExtensions[] = {".png", ".jpg", ".jpeg", ".pgm", ".ppm",
                                            ".bmp", ".tif", ".tiff", ".webp"};
  std::vector<fs::path> images;
  std::error_code ec;
  for (const auto& item : fs::directory_iterator(folder, ec)) {
    const std::string extension = lowerExtension(item.path());
    const bool known = std::any_of(std::begin(kExtensions), std::end(kExtensions),
                                   [&](const char* e) { return extension == e; });
    if (known && item.path().filename().string()[0] != '.') images.push_back(item.path());
  }
  std::sort(images.begin(), images.end(), [](const fs::path& a, const fs::path& b) {
    return naturalLess(a.filename().string(), b.filename().string());
  });
  return images;
}

std::string folderName(const fs::path& folder) {
  std::error_code ec;
  fs::path full = fs::weakly_canonical(folder, ec);
  if (ec) full = folder;
  return full.has_filename() ? full.filename().string() : full.parent_path().filename().string();
}

double medianRate(const std::vector<ImageEntry>& entries) {
  if (entries.size() < 2) return 0;
  std::vector<double> steps;
  for (size_t i = 1; i < entries.size(); ++i)
    steps.push_back(entries[i].timestamp - entries[i - 1].timestamp);
  const double step = upperMedian(std::move(steps));
  return step > 0 ? 1.0 / step : 0;
}

Result<std::unique_ptr<Sequence>> ListSequence::open(ImageList list) {
  if (list.entries.empty())
    return inputError("the sequence has no images", list.name, "check the list of images");
  std::unique_ptr<ListSequence> sequence(new ListSequence(std::move(list)));
  // A few damaged images are no reason to refuse a sequence, a wrong calibration is.
  const int probes = std::min(5, sequence->size());
  for (int i = 0; i < probes; ++i) {
    const fs::path& file = sequence->list_.entries[i].image;
    if (!readImageFile(file, cv::IMREAD_GRAYSCALE).ok() && i + 1 < probes) continue;
    sequence->judgeOrientation(file);
    auto image = sequence->read(i);
    if (!image) return image.error();
    break;
  }
  return std::unique_ptr<Sequence>(std::move(sequence));
}

void ListSequence::judgeOrientation(const fs::path& file) {
  const auto bytes = readImageBytes(file);
  const int orientation = bytes.ok() ? exifOrientation(bytes.value()) : 1;
  if (orientation == 1) return;
  const auto stored = readImageFile(file, cv::IMREAD_GRAYSCALE | cv::IMREAD_IGNORE_ORIENTATION);
  const Pinhole& p = list_.camera.pinhole;
  stored_orientation_ =
      stored.ok() && stored.value().cols == p.width && stored.value().rows == p.height;
  list_.notes.push_back(fmt::format(
      "the images have the EXIF orientation {}: {}", orientation,
      stored_orientation_ ? "not applied, as the calibration is for the pixels as stored"
                          : "applied, as the calibration is for the turned images"));
}

cv::Mat ListSequence::toEightBits(const cv::Mat& image) {
  if (image.depth() == CV_8U) return image;
  if (sixteen_bit_scale_ == 0) {
    // Cameras of 10 to 14 bits are stored as 16: the upper eight bits alone would leave few grey
    // levels.
    double brightest = 0;
    cv::minMaxLoc(image, nullptr, &brightest);
    double top = 1023;
    while (top < brightest && top < 65535) top = 4 * top + 3;
    sixteen_bit_scale_ = 255 / std::min(top, 65535.0);
  }
  cv::Mat eight;
  image.convertTo(eight, CV_8U, sixteen_bit_scale_);
  return eight;
}

Result<SequenceImage> ListSequence::read(int index) {
  const ImageEntry& entry = list_.entries.at(index);
  const int orientation = stored_orientation_ ? cv::IMREAD_IGNORE_ORIENTATION : 0;
  auto image = readImageFile(entry.image, cv::IMREAD_GRAYSCALE | cv::IMREAD_ANYDEPTH | orientation);
  if (!image) return image.error();
  if (image.value().depth() != CV_8U && image.value().depth() != CV_16U)
    return inputError("the pixels are neither 8-bit nor 16-bit integers", entry.image.string(),
                      "convert the images to 8-bit grey");
  const Pinhole& p = list_.camera.pinhole;
  if (image.value().cols != p.width || image.value().rows != p.height)
    return inputError("the image is " + sizeText(image.value().cols, image.value().rows) +
                          " pixels, but " + list_.camera_source + " says " +
                          sizeText(p.width, p.height),
                      entry.image.string(), "use the calibration that belongs to these images");
  return SequenceImage{index, entry.timestamp, toEightBits(image.value())};
}

Result<cv::Mat> ListSequence::readDepth(int index) {
  const ImageEntry& entry = list_.entries.at(index);
  if (entry.depth.empty()) return cv::Mat();
  auto raw = readImageFile(entry.depth, cv::IMREAD_UNCHANGED);
  if (!raw) return raw.error();
  const Pinhole& p = list_.camera.pinhole;
  const cv::Mat& image = raw.value();
  if (image.type() != CV_16UC1 || image.cols != p.width || image.rows != p.height)
    return inputError(
        "the depth image is not 16-bit grey of " + sizeText(p.width, p.height) + " pixels",
        entry.depth.string(), "depth images are 16-bit PNG of the camera's size");
  cv::Mat depth;
  image.convertTo(depth, CV_32F, 1.0 / list_.depth_scale);
  return depth;
}

}  // namespace svoscope
