// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "engine/base/text_rows.h"
#include "engine/dataset/camera_file.h"
#include "engine/dataset/ground_truth.h"
#include "engine/dataset/list_sequence.h"
#include "engine/dataset/loader.h"

namespace svoscope {
namespace {

namespace fs = std::filesystem;

const double kDepthAssociation = 0.02;  ///< s
const char* const kLayout =
    "a TUM folder needs rgb.txt with lines 'timestamp filename', the images it lists and "
    "camera.yaml";

/// Lines "timestamp filename"; time must increase from line to line.
Result<std::vector<ImageEntry>> readStampedFiles(const fs::path& file) {
  const auto rows = readTextRows(file, kLayout);
  if (!rows) return rows.error();
  std::vector<ImageEntry> entries;
  for (const TextRow& row : rows.value()) {
    const auto stamp = finiteNumbers(row, 0, 1, file, kLayout);
    if (!stamp) return stamp.error();
    if (row.fields.size() < 2)
      return inputError("the file name is missing", place(file, row.line), kLayout);
    const double t = stamp.value()[0];
    if (!entries.empty() && t <= entries.back().timestamp)
      return inputError("time does not increase", place(file, row.line),
                        "sort the lines by time and remove duplicates");
    entries.push_back({t, file.parent_path() / row.fields[1], {}});
  }
  if (entries.empty()) return inputError("the list is empty", file.string(), kLayout);
  return entries;
}

/// Gives every depth image to the nearest image in time.
void attachDepth(const std::vector<ImageEntry>& depths, std::vector<ImageEntry>& images) {
  std::vector<double> best(images.size(), kDepthAssociation);
  for (const ImageEntry& depth : depths) {
    auto next = std::lower_bound(images.begin(), images.end(), depth.timestamp,
                                 [](const ImageEntry& e, double t) { return e.timestamp < t; });
    if (next == images.end() || (next != images.begin() && depth.timestamp - (next - 1)->timestamp <
                                                               next->timestamp - depth.timestamp))
      --next;
    const double distance = std::abs(next->timestamp - depth.timestamp);
    double& nearest = best[next - images.begin()];
    if (distance > nearest) continue;
    nearest = distance;
    next->depth = depth.image;
  }
}

/// Calibration known from the folder's name, as the benchmark's archives are named.
std::string presetOf(const std::string& name) {
  for (const char* digit : {"1", "2", "3"})
    for (const char* stem : {"freiburg", "fr"})
      if (name.find(std::string(stem) + digit) != std::string::npos)
        return std::string("tum-fr") + digit;
  return "";
}

Status findCamera(const fs::path& folder, ImageList& list) {
  const fs::path file = folder / "camera.yaml";
  const std::string preset = presetOf(list.name);
  const bool use_preset = !fs::exists(file) && !preset.empty();
  const auto camera = use_preset ? cameraPreset(preset) : readCameraFile(file);
  if (!camera) return camera.error();
  list.camera = camera.value();
  list.camera_source = use_preset ? "the preset " + preset : file.string();
  return Done{};
}

bool hasList(const fs::path& folder) { return fs::exists(folder / "rgb.txt"); }
bool hasImagesOnly(const fs::path& folder) { return fs::is_directory(folder / "rgb"); }

OpenedSequence openFolder(const fs::path& folder) {
  ImageList list;
  list.name = folderName(folder);
  auto entries = readStampedFiles(folder / "rgb.txt");
  if (!entries) return entries.error();
  list.entries = std::move(entries.value());
  const Status found = findCamera(folder, list);
  if (!found) return found.error();
  if (list.camera.rate_hz == 0) list.camera.rate_hz = medianRate(list.entries);

  if (fs::exists(folder / "groundtruth.txt")) {
    auto truth = readTumTrajectory(folder / "groundtruth.txt");
    if (!truth) return truth.error();
    list.truth = std::move(truth.value());
  }
  if (fs::exists(folder / "depth.txt")) {
    const auto depths = readStampedFiles(folder / "depth.txt");
    if (!depths) return depths.error();
    attachDepth(depths.value(), list.entries);
  }
  return ListSequence::open(std::move(list));
}

}  // namespace

/// rgb.txt, the images it lists, camera.yaml (or a folder name with freiburg1/2/3 or fr1/2/3);
/// optional groundtruth.txt and depth.txt (16-bit PNG, metres x 5000; each belongs to the nearest
/// image within 0.02 s).
Loader tumLoader() {
  return {Loader::Takes::folder, "rgb.txt (TUM RGB-D)", hasList, openFolder, hasImagesOnly};
}

}  // namespace svoscope
