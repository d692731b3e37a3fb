// SPDX-License-Identifier: MIT
#include "engine/base/text_rows.h"
#include "engine/dataset/find_calibration.h"
#include "engine/dataset/list_sequence.h"
#include "engine/dataset/loader.h"
#include "engine/dataset/truth.h"

namespace svoscope {
namespace {

namespace fs = std::filesystem;

const char* const kLayout =
    "an ASL folder needs mav0/cam0/data.csv with lines 'timestamp [ns],filename', "
    "mav0/cam0/data/ and mav0/cam0/sensor.yaml";

Result<std::vector<ImageEntry>> readImageList(const fs::path& file) {
  const auto rows = readTextRows(file, kLayout);
  if (!rows) return rows.error();
  std::vector<ImageEntry> entries;
  for (const TextRow& row : rows.value()) {
    const auto stamp = parseNanoseconds(row.fields[0]);
    if (!stamp || row.fields.size() < 2)
      return inputError("not a line 'timestamp [ns],filename'", place(file, row.line), kLayout);
    if (!entries.empty() && *stamp <= entries.back().timestamp)
      return inputError("time does not increase", place(file, row.line),
                        "sort the lines by time and remove duplicates");
    entries.push_back({*stamp, file.parent_path() / "data" / row.fields[1], {}});
  }
  if (entries.empty()) return inputError("the list is empty", file.string(), kLayout);
  return entries;
}

void attachBodyTruth(const fs::path& mav, const std::optional<SE3>& T_body_cam, ImageList& list) {
  for (const char* source : {"state_groundtruth_estimate0", "mocap0"}) {
    const fs::path file = mav / source / "data.csv";
    if (fs::exists(file)) return attachTruth(file, T_body_cam, list);
  }
}

/// sensor.yaml of the camera, or what the user names, or a calibration beside (TUM-VI: dso/).
Result<FoundCalibration> findSensor(const fs::path& folder, const fs::path& mav,
                                    const OpenOptions& options) {
  OpenOptions chosen = options;
  const fs::path sensor = mav / "cam0" / "sensor.yaml";
  const bool elsewhere = findCalibration(folder, options).ok();
  if (options.camera.empty() && (fs::exists(sensor) || !elsewhere)) chosen.camera = sensor;
  return findCalibration(folder, chosen);
}

bool isAsl(const fs::path& folder) {
  return fs::is_directory(folder / "mav0") || fs::is_directory(folder / "cam0");
}

OpenedSequence openFolder(const fs::path& folder, const OpenOptions& options) {
  const bool above = fs::is_directory(folder / "mav0");
  const fs::path mav = above ? folder / "mav0" : folder;
  ImageList list;
  list.name = folderName(folder);
  // "V1_01_easy/mav0" is better known by the name of the folder above.
  if (list.name == "mav0") list.name = folderName(fs::weakly_canonical(folder).parent_path());
  auto entries = readImageList(mav / "cam0" / "data.csv");
  if (!entries) return entries.error();
  list.entries = std::move(entries.value());

  const auto found = findSensor(folder, mav, options);
  if (!found) return found.error();
  const Calibration& calibration = found.value().calibration;
  list.camera = calibration.camera;
  list.camera_source = found.value().file.string();
  list.notes = calibration.notes;
  if (list.camera.rate_hz == 0) list.camera.rate_hz = medianRate(list.entries);
  const std::optional<SE3> T_body_cam =
      calibration.has_body ? std::make_optional(calibration.T_body_cam) : std::nullopt;
  attachBodyTruth(mav, T_body_cam, list);
  if (!list.truth.empty() && !calibration.has_body)
    list.notes.push_back(
        "the calibration does not say where the camera sits on the body: poses of "
        "the body are taken as the camera's");
  return ListSequence::open(std::move(list));
}

}  // namespace

/// The folder that contains mav0, or mav0: cam0/data.csv, cam0/data/, cam0/sensor.yaml; optional
/// state_groundtruth_estimate0/data.csv or mocap0/data.csv, poses of the body turned into poses of
/// the camera: T_world_cam = T_world_body * T_body_cam with T_body_cam = T_BS of cam0.
Loader eurocLoader() { return {Loader::Takes::folder, "mav0/ (EuRoC/ASL)", isAsl, openFolder}; }

}  // namespace svoscope
