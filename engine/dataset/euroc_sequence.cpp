// SPDX-License-Identifier: MIT
#include "engine/base/text_rows.h"
#include "engine/dataset/camera_file.h"
#include "engine/dataset/ground_truth.h"
#include "engine/dataset/list_sequence.h"
#include "engine/dataset/loader.h"

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

Result<Trajectory> readCameraTruth(const fs::path& mav, const SE3& T_body_cam) {
  for (const char* source : {"state_groundtruth_estimate0", "mocap0"}) {
    const fs::path file = mav / source / "data.csv";
    if (!fs::exists(file)) continue;
    auto truth = readEurocTrajectory(file);
    if (!truth) return truth.error();
    for (StampedPose& pose : truth.value()) pose.T_world_cam = pose.T_world_cam * T_body_cam;
    return truth;
  }
  return Trajectory{};
}

bool isAsl(const fs::path& folder) {
  return fs::is_directory(folder / "mav0") || fs::is_directory(folder / "cam0");
}

OpenedSequence openFolder(const fs::path& folder) {
  const bool above = fs::is_directory(folder / "mav0");
  const fs::path mav = above ? folder / "mav0" : folder;
  ImageList list;
  list.name = folderName(folder);
  // "V1_01_easy/mav0" is better known by the name of the folder above.
  if (list.name == "mav0") list.name = folderName(fs::weakly_canonical(folder).parent_path());
  auto entries = readImageList(mav / "cam0" / "data.csv");
  if (!entries) return entries.error();
  list.entries = std::move(entries.value());

  const fs::path sensor = mav / "cam0" / "sensor.yaml";
  const auto mounted = readSensorFile(sensor);
  if (!mounted) return mounted.error();
  list.camera = mounted.value().camera;
  list.camera_source = sensor.string();
  if (list.camera.rate_hz == 0) list.camera.rate_hz = medianRate(list.entries);

  auto truth = readCameraTruth(mav, mounted.value().T_body_cam);
  if (!truth) return truth.error();
  list.truth = std::move(truth.value());
  return ListSequence::open(std::move(list));
}

}  // namespace

/// The folder that contains mav0, or mav0: cam0/data.csv, cam0/data/, cam0/sensor.yaml; optional
/// state_groundtruth_estimate0/data.csv or mocap0/data.csv, poses of the body turned into poses of
/// the camera: T_world_cam = T_world_body * T_body_cam with T_body_cam = T_BS of cam0.
Loader eurocLoader() { return {Loader::Takes::folder, "mav0/ (EuRoC/ASL)", isAsl, openFolder}; }

}  // namespace svoscope
