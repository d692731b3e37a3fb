// SPDX-License-Identifier: MIT
#include "engine/dataset/camera_file.h"
#include "engine/dataset/ground_truth.h"
#include "engine/dataset/list_sequence.h"
#include "engine/dataset/loaders.h"

namespace svoscope {

namespace fs = std::filesystem;

OpenedSequence openImageFolder(const fs::path& folder) {
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

}  // namespace svoscope
