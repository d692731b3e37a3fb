// SPDX-License-Identifier: MIT
#include "engine/dataset/list_sequence.h"
#include "engine/dataset/loaders.h"
#include "engine/dataset/sequence.h"
#include "engine/dataset/synthetic/synthetic.h"

namespace svoscope {
namespace {

namespace fs = std::filesystem;

const char* const kKinds =
    "a sequence is synthetic:PRESET, a folder with rgb.txt (TUM RGB-D), mav0/ (EuRoC/ASL), "
    "image_0/ (KITTI odometry) or images and camera.yaml, or a video with its calibration beside";

bool isAsl(const fs::path& folder) {
  return fs::is_directory(folder / "mav0") || fs::is_directory(folder / "cam0");
}

OpenedSequence openPath(const std::string& spec) {
  const fs::path path(spec);
  std::error_code ec;
  if (spec.empty() || !fs::exists(path, ec))
    return inputError("there is no such file or folder", spec, kKinds);
  if (!fs::is_directory(path, ec)) return openVideoSequence(path);
  if (fs::exists(path / "rgb.txt")) return openTumSequence(path);
  if (isAsl(path)) return openEurocSequence(path);
  const bool kitti_lists = fs::exists(path / "times.txt") && fs::exists(path / "calib.txt");
  if (kitti_lists || fs::is_directory(path / "image_0")) return openKittiSequence(path);
  if (!sortedImages(path).empty()) return openImageFolder(path);
  if (fs::is_directory(path / "rgb")) return openTumSequence(path);  // says that rgb.txt is missing
  return inputError("no known sequence layout", spec, kKinds);
}

}  // namespace

OpenedSequence openSequence(const std::string& spec) {
  if (isSyntheticSpec(spec)) return openSyntheticSequence(spec);
  try {
    return openPath(spec);
  } catch (const fs::filesystem_error& e) {
    return inputError(e.code().message(), spec, "check that you may read the folder");
  }
}

}  // namespace svoscope
