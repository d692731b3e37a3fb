// SPDX-License-Identifier: MIT
#include <algorithm>
#include <opencv2/imgcodecs.hpp>

#include "engine/base/text_rows.h"
#include "engine/dataset/ground_truth.h"
#include "engine/dataset/list_sequence.h"
#include "engine/dataset/loader.h"

namespace svoscope {
namespace {

namespace fs = std::filesystem;

const char* const kLayout =
    "a KITTI odometry folder (like sequences/00) needs image_0/, times.txt and calib.txt with a "
    "line P0";

/// Row P0 of calib.txt: the projection matrix of the rectified left grey camera.
Result<Pinhole> readProjection(const fs::path& file) {
  const auto rows = readTextRows(file, kLayout);
  if (!rows) return rows.error();
  for (const TextRow& row : rows.value()) {
    if (row.fields[0] != "P0:" && row.fields[0] != "P0") continue;
    const auto numbers = finiteNumbers(row, 1, 12, file, kLayout);
    if (!numbers) return numbers.error();
    const auto& v = numbers.value();
    return Pinhole{0, 0, v[0], v[5], v[2], v[6]};
  }
  return inputError("there is no line P0", file.string(), kLayout);
}

Result<std::vector<ImageEntry>> listImages(const fs::path& folder) {
  const auto images = sortedImages(folder / "image_0");
  if (images.empty())
    return inputError("there are no images", (folder / "image_0").string(), kLayout);
  const fs::path file = folder / "times.txt";
  const auto rows = readTextRows(file, kLayout);
  if (!rows) return rows.error();
  if (rows.value().size() < images.size())
    return inputError(std::to_string(rows.value().size()) + " times for " +
                          std::to_string(images.size()) + " images",
                      file.string(), kLayout);
  std::vector<ImageEntry> entries;
  for (size_t i = 0; i < images.size(); ++i) {
    const TextRow& row = rows.value()[i];
    const auto stamp = finiteNumbers(row, 0, 1, file, kLayout);
    if (!stamp) return stamp.error();
    if (i > 0 && stamp.value()[0] <= entries.back().timestamp)
      return inputError("time does not increase", place(file, row.line),
                        "times.txt holds one increasing time per image");
    entries.push_back({stamp.value()[0], images[i], {}});
  }
  return entries;
}

Result<Trajectory> readTruth(const fs::path& folder, const std::vector<ImageEntry>& entries) {
  const fs::path full = fs::weakly_canonical(folder);
  for (const fs::path& file :
       {full / "poses.txt", full / ".." / ".." / "poses" / (folderName(folder) + ".txt")}) {
    if (!fs::exists(file)) continue;
    const auto poses = readKittiPoses(file);
    if (!poses) return poses.error();
    Trajectory truth;
    for (size_t i = 0; i < std::min(entries.size(), poses.value().size()); ++i)
      truth.push_back({entries[i].timestamp, poses.value()[i]});
    return truth;
  }
  return Trajectory{};
}

bool isKitti(const fs::path& folder) {
  const bool lists = fs::exists(folder / "times.txt") && fs::exists(folder / "calib.txt");
  return lists || fs::is_directory(folder / "image_0");
}

OpenedSequence openFolder(const fs::path& folder) {
  ImageList list;
  list.name = folderName(folder);
  auto entries = listImages(folder);
  if (!entries) return entries.error();
  list.entries = std::move(entries.value());

  const fs::path calib = folder / "calib.txt";
  const auto projection = readProjection(calib);
  if (!projection) return projection.error();
  list.camera.pinhole = projection.value();
  // calib.txt does not state the resolution: the first image does.
  const auto first = readImageFile(list.entries[0].image, cv::IMREAD_GRAYSCALE);
  if (!first) return first.error();
  list.camera.pinhole.width = first.value().cols;
  list.camera.pinhole.height = first.value().rows;
  list.camera_source = list.entries[0].image.string();
  list.camera.rate_hz = medianRate(list.entries);
  const Status status = list.camera.check();
  if (!status) return inputError(status.error().what, calib.string(), kLayout);

  auto truth = readTruth(folder, list.entries);
  if (!truth) return truth.error();
  list.truth = std::move(truth.value());
  return ListSequence::open(std::move(list));
}

}  // namespace

/// A folder like sequences/00: image_0/, calib.txt with P0, times.txt; optional poses.txt there or
/// ../../poses/00.txt (poses of the left grey camera).
Loader kittiLoader() {
  return {Loader::Takes::folder, "image_0/ (KITTI odometry)", isKitti, openFolder};
}

}  // namespace svoscope
