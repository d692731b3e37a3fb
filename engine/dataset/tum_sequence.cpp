// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/stamps.h"
#include "engine/base/text_rows.h"
#include "engine/dataset/find_calibration.h"
#include "engine/dataset/list_sequence.h"
#include "engine/dataset/loader.h"
#include "engine/dataset/truth.h"

namespace svoscope {
namespace {

namespace fs = std::filesystem;

const double kDepthAssociation = 0.02;  ///< s
const char* const kLayout =
    "a TUM folder needs rgb.txt with lines 'timestamp filename', the images it lists and "
    "camera.yaml";

/// The rest of a line is the name of the file: names may hold blanks. "\\" separates folders where
/// the list was written on Windows.
fs::path listedFile(const TextRow& row, std::size_t first, const fs::path& folder) {
  std::string name = row.fields[first];
  for (std::size_t i = first + 1; i < row.fields.size(); ++i) name += " " + row.fields[i];
  std::error_code ec;
  if (name.find('\\') != std::string::npos && !fs::exists(folder / name, ec))
    std::replace(name.begin(), name.end(), '\\', '/');
  return folder / name;
}

/// Entries of rows with a time in column `time` and a file from column `name` on; time must
/// increase.
Result<std::vector<ImageEntry>> stampedFiles(const std::vector<TextRow>& rows, std::size_t time,
                                             std::size_t name, const fs::path& file) {
  std::vector<std::string> fields;
  for (const TextRow& row : rows) {
    if (row.fields.size() <= name)
      return inputError("the file name is missing", place(file, row.line), kLayout);
    fields.push_back(row.fields[time]);
  }
  std::size_t bad = 0;
  const auto stamps = readStamps(fields, &bad);
  if (!stamps)
    return inputError("'" + fields[bad] + "' is not a finite number", place(file, rows[bad].line),
                      kLayout);
  std::vector<ImageEntry> entries;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double t = stamps->seconds[i];
    if (!entries.empty() && t <= entries.back().timestamp)
      return inputError("time does not increase", place(file, rows[i].line),
                        "sort the lines by time and remove duplicates");
    entries.push_back({t, listedFile(rows[i], name, file.parent_path()), {}});
  }
  if (entries.empty()) return inputError("the list is empty", file.string(), kLayout);
  return entries;
}

/// Lines "timestamp filename".
Result<std::vector<ImageEntry>> readStampedFiles(const fs::path& file) {
  const auto rows = readTextRows(file, kLayout);
  if (!rows) return rows.error();
  return stampedFiles(rows.value(), 0, 1, file);
}

/// Lines "time image time depth" in any order of the two, as associate.py and ICL-NUIM write them.
Result<std::vector<ImageEntry>> readAssociations(const fs::path& file) {
  const auto rows = readTextRows(file, kLayout);
  if (!rows) return rows.error();
  std::vector<TextRow> images = rows.value();
  std::vector<fs::path> depths;
  for (TextRow& row : images) {
    if (row.fields.size() != 4)
      return inputError("not a line 'time image time depth'", place(file, row.line), kLayout);
    if (row.fields[1].rfind("depth", 0) == 0) {
      std::swap(row.fields[0], row.fields[2]);
      std::swap(row.fields[1], row.fields[3]);
    }
    depths.push_back(file.parent_path() / row.fields[3]);
    row.fields.resize(2);
  }
  auto entries = stampedFiles(images, 0, 1, file);
  if (!entries) return entries.error();
  std::error_code ec;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    if (fs::exists(depths[i], ec)) entries.value()[i].depth = depths[i];
  }
  return entries;
}

/// Whole numbers one apart are numbers of frames and no times: ICL-NUIM's associations.
bool areFrameNumbers(const std::vector<ImageEntry>& entries) {
  if (entries.size() < 2) return false;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const double t = entries[i].timestamp;
    if (t != std::floor(t) || t > 1e8) return false;
    if (i > 0 && t - entries[i - 1].timestamp != 1) return false;
  }
  return true;
}

void countTimes(const OpenOptions& options, ImageList& list) {
  const double given = options.rate_hz > 0 ? options.rate_hz : list.camera.rate_hz;
  list.times = given > 0 ? TimeSource::rate : TimeSource::assumed;
  const double rate = given > 0 ? given : kAssumedRate;
  for (ImageEntry& entry : list.entries) entry.timestamp /= rate;
  list.notes.push_back(fmt::format(
      given > 0 ? "the list numbers the frames: their times are counted with {:.4g} Hz"
                : "the list numbers the frames, and their rate is unknown: {:.4g} Hz is assumed, "
                  "and no error over time is computed; give the rate with --rate HZ",
      rate));
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

Status findCamera(const fs::path& folder, const OpenOptions& options, ImageList& list) {
  const std::string preset = presetOf(list.name);
  const bool own = !options.camera.empty() || fs::exists(folder / "camera.yaml");
  if (!own && !preset.empty()) {
    const auto camera = cameraPreset(preset);
    if (!camera) return camera.error();
    list.camera = camera.value();
    list.camera_source = "the preset " + preset;
    return Done{};
  }
  const auto found = findCalibration(folder, options, sizeOfImage(list.entries.front().image));
  if (!found) return found.error();
  list.camera = found.value().calibration.camera;
  list.camera_source = found.value().file.string();
  list.notes = found.value().calibration.notes;
  return Done{};
}

bool hasList(const fs::path& folder) {
  return fs::exists(folder / "rgb.txt") || fs::exists(folder / "associations.txt");
}
bool hasImagesOnly(const fs::path& folder) { return fs::is_directory(folder / "rgb"); }

Status attachDepthList(const fs::path& folder, ImageList& list) {
  if (!fs::exists(folder / "depth.txt")) return Done{};
  const auto depths = readStampedFiles(folder / "depth.txt");
  if (!depths) return depths.error();
  attachDepth(depths.value(), list.entries);
  return Done{};
}

OpenedSequence openFolder(const fs::path& folder, const OpenOptions& options) {
  ImageList list;
  list.name = folderName(folder);
  const bool associated =
      !fs::exists(folder / "rgb.txt") && fs::exists(folder / "associations.txt");
  auto entries = associated ? readAssociations(folder / "associations.txt")
                            : readStampedFiles(folder / "rgb.txt");
  if (!entries) return entries.error();
  list.entries = std::move(entries.value());
  const Status found = findCamera(folder, options, list);
  if (!found) return found.error();
  if (areFrameNumbers(list.entries)) countTimes(options, list);
  if (list.camera.rate_hz == 0) list.camera.rate_hz = medianRate(list.entries);
  attachTruth(folder / "groundtruth.txt", std::nullopt, list);
  const Status depth = attachDepthList(folder, list);
  if (!depth) return depth.error();
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
