// SPDX-License-Identifier: MIT
#include <map>

#include "engine/base/text_rows.h"
#include "engine/dataset/find_calibration.h"
#include "engine/dataset/list_sequence.h"
#include "engine/dataset/loader.h"
#include "engine/dataset/truth.h"

namespace svoscope {
namespace {

namespace fs = std::filesystem;

const char* const kLayout =
    "a TUM-mono folder (DSO) needs images/, times.txt with lines 'name time [exposure]' and "
    "camera.txt";

/// Times by the name of the image, which stands before them.
Result<std::map<std::string, double>> readTimes(const fs::path& file) {
  const auto rows = readTextRows(file, kLayout);
  if (!rows) return rows.error();
  std::map<std::string, double> times;
  for (const TextRow& row : rows.value()) {
    const auto stamp = finiteNumbers(row, 1, 1, file, kLayout);
    if (!stamp) return stamp.error();
    times[fs::path(row.fields[0]).stem().string()] = stamp.value()[0];
  }
  if (times.empty()) return inputError("the list is empty", file.string(), kLayout);
  return times;
}

Result<std::vector<ImageEntry>> listImages(const fs::path& folder) {
  const auto times = readTimes(folder / "times.txt");
  if (!times) return times.error();
  std::vector<ImageEntry> entries;
  for (const fs::path& image : sortedImages(folder / "images")) {
    const auto time = times.value().find(image.stem().string());
    if (time == times.value().end())
      return inputError("times.txt has no time for the image", image.string(), kLayout);
    if (!entries.empty() && time->second <= entries.back().timestamp)
      return inputError("time does not increase at " + image.filename().string(),
                        (folder / "times.txt").string(), "sort the lines by time");
    entries.push_back({time->second, image, {}});
  }
  if (entries.empty())
    return inputError("there are no images", (folder / "images").string(),
                      "extract images.zip into images/");
  return entries;
}

bool isTumMono(const fs::path& folder) {
  return fs::is_directory(folder / "images") && fs::exists(folder / "times.txt");
}

OpenedSequence openFolder(const fs::path& folder, const OpenOptions& options) {
  ImageList list;
  list.name = folderName(folder);
  auto entries = listImages(folder);
  if (!entries) return entries.error();
  list.entries = std::move(entries.value());
  const auto found = findCalibration(folder, options, sizeOfImage(list.entries.front().image));
  if (!found) return found.error();
  list.camera = found.value().calibration.camera;
  list.camera_source = found.value().file.string();
  list.notes = found.value().calibration.notes;
  list.camera.rate_hz = medianRate(list.entries);
  for (const char* name : {"groundtruthSync.txt", "groundtruth.txt"}) {
    if (list.truth.empty()) attachTruth(folder / name, std::nullopt, list);
  }
  return ListSequence::open(std::move(list));
}

}  // namespace

/// images/ with times.txt (name, seconds, exposure) and camera.txt, as DSO takes it; optional
/// groundtruthSync.txt in TUM format, in parts.
Loader tumMonoLoader() {
  return {Loader::Takes::folder, "images/ and times.txt (TUM-mono, DSO)", isTumMono, openFolder};
}

}  // namespace svoscope
