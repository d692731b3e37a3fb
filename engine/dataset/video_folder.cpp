// SPDX-License-Identifier: MIT
#include "engine/dataset/loader.h"
#include "engine/dataset/video_sequence.h"

namespace svoscope {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> videosOf(const fs::path& folder) {
  std::vector<fs::path> videos;
  std::error_code ec;
  for (const auto& item : fs::directory_iterator(folder, ec)) {
    if (hasVideoName(item.path())) videos.push_back(item.path());
  }
  return videos;
}

bool hasOneVideo(const fs::path& folder) { return videosOf(folder).size() == 1; }

OpenedSequence openFolder(const fs::path& folder, const OpenOptions& options) {
  return openVideo(videosOf(folder).front(), options);
}

}  // namespace

/// A folder with a single video and its calibration.
Loader videoFolderLoader() {
  return {Loader::Takes::folder, "one video and its calibration", hasOneVideo, openFolder};
}

}  // namespace svoscope
