// SPDX-License-Identifier: MIT
#include "engine/dataset/find_calibration.h"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>

#include "engine/dataset/list_sequence.h"

namespace svoscope {

namespace {

namespace fs = std::filesystem;

const char* const kUsualNames[] = {"camera.yaml",      "camera.txt",       "camera.yml",
                                   "camchain.yaml",    "camera_info.yaml", "calibration.yaml",
                                   "calibration.json", "calib.yaml",       "calib.json",
                                   "ost.yaml",         "sensor.yaml",      "cameras.txt"};

/// The places that other tools put a calibration to, seen from the images.
std::vector<fs::path> placesOf(const fs::path& folder) {
  return {folder, folder / "dso", folder / "calibration", folder / ".."};
}

bool mayBeCalibration(const fs::path& file) {
  const std::string extension = file.extension().string();
  if (extension == ".yaml" || extension == ".yml" || extension == ".json") return true;
  return extension == ".txt" && file.stem().string().find("cam") == 0;
}

/// Files with unusual names ("camchain-cam0.yaml") that read as a calibration.
std::vector<fs::path> others(const fs::path& folder, ImageSize images) {
  std::vector<fs::path> found;
  std::error_code ec;
  for (const auto& item : fs::directory_iterator(folder, ec)) {
    if (!mayBeCalibration(item.path())) continue;
    if (readCalibration(item.path(), images).ok()) found.push_back(item.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

Result<FoundCalibration> readFound(const fs::path& file, ImageSize images) {
  auto read = readCalibration(file, images);
  if (!read) return read.error();
  return FoundCalibration{std::move(read).value(), file};
}

}  // namespace

ImageSize sizeOfImage(const fs::path& image) {
  const auto read = readImageFile(image, cv::IMREAD_GRAYSCALE);
  if (!read) return {};
  return {read.value().cols, read.value().rows};
}

Result<FoundCalibration> findCalibration(const fs::path& folder, const OpenOptions& options,
                                         ImageSize images) {
  if (!options.camera.empty()) return readFound(options.camera, images);
  std::error_code ec;
  for (const fs::path& place : placesOf(folder)) {
    for (const char* name : kUsualNames) {
      if (fs::is_regular_file(place / name, ec)) return readFound(place / name, images);
    }
  }
  for (const fs::path& place : placesOf(folder)) {
    const auto found = others(place, images);
    if (found.size() == 1) return readFound(found.front(), images);
    if (found.empty()) continue;
    std::string names;
    for (const fs::path& file : found)
      names += (names.empty() ? "" : ", ") + file.filename().string();
    return inputError("there are several calibrations: " + names, place.string(),
                      "choose one with --camera FILE, or name it camera.yaml");
  }
  return readFound(folder / "camera.yaml", images);  // says what is missing
}

}  // namespace svoscope
