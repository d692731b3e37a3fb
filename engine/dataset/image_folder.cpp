// SPDX-License-Identifier: MIT
#include "engine/dataset/camera_file.h"
#include "engine/dataset/ground_truth.h"
#include "engine/dataset/list_sequence.h"
#include "engine/dataset/loader.h"

namespace svoscope {
namespace {

namespace fs = std::filesystem;

bool hasImages(const fs::path& folder) { return !sortedImages(folder).empty(); }

OpenedSequence openFolder(const fs::path& folder) {
  ImageList list;
  list.name = folderName(folder);
  const fs::path file = folder / "camera.yaml";
  const auto camera = readCameraFile(file);
  if (!camera) return camera.error();
  list.camera = camera.value();
  list.camera_source = file.string();
  if (list.camera.rate_hz == 0) list.camera.rate_hz = 30;

  const auto images = sortedImages(folder);
  if (images.empty())
    return inputError("there are no images", folder.string(),
                      "an image folder holds PNG, JPEG, PGM, BMP, TIFF or WebP and camera.yaml");
  for (size_t i = 0; i < images.size(); ++i)
    list.entries.push_back({static_cast<double>(i) / list.camera.rate_hz, images[i], {}});
  if (fs::exists(folder / "groundtruth.txt")) {
    auto truth = readTumTrajectory(folder / "groundtruth.txt");
    if (!truth) return truth.error();
    list.truth = std::move(truth.value());
  }
  return ListSequence::open(std::move(list));
}

}  // namespace

/// Images in natural order and camera.yaml, whose rate_hz (default 30) gives the time stamps;
/// optional groundtruth.txt in TUM format.
Loader imageFolderLoader() {
  return {Loader::Takes::folder, "images and camera.yaml", hasImages, openFolder};
}

}  // namespace svoscope
