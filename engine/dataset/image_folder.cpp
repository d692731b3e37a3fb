// SPDX-License-Identifier: MIT
#include "engine/dataset/find_calibration.h"
#include "engine/dataset/image_times.h"
#include "engine/dataset/list_sequence.h"
#include "engine/dataset/loader.h"
#include "engine/dataset/truth.h"

namespace svoscope {
namespace {

namespace fs = std::filesystem;

/// The folder that holds the images: itself, or the only one below it that has some.
fs::path imagesOf(const fs::path& folder) {
  if (!sortedImages(folder).empty()) return folder;
  std::vector<fs::path> below;
  std::error_code ec;
  for (const auto& item : fs::directory_iterator(folder, ec)) {
    if (item.is_directory(ec) && !sortedImages(item.path()).empty()) below.push_back(item.path());
  }
  return below.size() == 1 ? below.front() : fs::path();
}

bool hasImages(const fs::path& folder) { return !sortedImages(folder).empty(); }
bool hasImagesBelow(const fs::path& folder) { return !imagesOf(folder).empty(); }

OpenedSequence openFolder(const fs::path& folder, const OpenOptions& options) {
  ImageList list;
  list.name = folderName(folder);
  const auto images = sortedImages(imagesOf(folder));
  if (images.empty())
    return inputError("there are no images", folder.string(),
                      "an image folder holds PNG, JPEG, PGM, BMP, TIFF or WebP and camera.yaml");
  const auto found = findCalibration(folder, options, sizeOfImage(images.front()));
  if (!found) return found.error();
  list.camera = found.value().calibration.camera;
  list.camera_source = found.value().file.string();
  list.notes = found.value().calibration.notes;
  const ImageTimes times = timesOfImages(images, list.camera, options);
  list.times = times.source;
  list.notes.insert(list.notes.end(), times.notes.begin(), times.notes.end());
  for (size_t i = 0; i < images.size(); ++i)
    list.entries.push_back({times.seconds[i], images[i], {}});
  list.camera.rate_hz = medianRate(list.entries);
  attachTruth(folder / "groundtruth.txt", std::nullopt, list);
  return ListSequence::open(std::move(list));
}

}  // namespace

/// Images in natural order, here or in the only folder below, and a calibration. Times are those in
/// the names of the images, or counted (image_times.h); optional groundtruth.txt.
Loader imageFolderLoader() {
  return {Loader::Takes::folder, "images and camera.yaml", hasImages, openFolder, hasImagesBelow};
}

}  // namespace svoscope
