// SPDX-License-Identifier: MIT
#include <algorithm>
#include <opencv2/imgcodecs.hpp>

#include "engine/base/text_rows.h"
#include "engine/dataset/calibration/calibration.h"
#include "engine/dataset/find_calibration.h"
#include "engine/dataset/list_sequence.h"
#include "engine/dataset/loader.h"
#include "engine/eval/trajectory_file.h"

namespace svoscope {
namespace {

namespace fs = std::filesystem;

const char* const kLayout =
    "a KITTI odometry folder (like sequences/00) needs image_0/ (or image_2/), times.txt and "
    "calib.txt with a line P0 (P2)";

/// The camera whose images are there: left grey, else left colour.
struct KittiCamera {
  const char* images = "image_0";
  const char* row = "P0";
};

KittiCamera cameraOf(const fs::path& folder) {
  if (!fs::is_directory(folder / "image_0") && fs::is_directory(folder / "image_2"))
    return {"image_2", "P2"};
  return {};
}

struct Projection {
  Pinhole pinhole;
  double offset_m = 0;  ///< of the camera to the right of the left grey one, whose poses are known
};

/// Row P0 or P2 of calib.txt: the projection matrix of the rectified camera.
Result<Projection> readProjection(const fs::path& file, const std::string& name) {
  const auto rows = readTextRows(file, kLayout);
  if (!rows) return rows.error();
  for (const TextRow& row : rows.value()) {
    if (row.fields[0] != name + ":" && row.fields[0] != name) continue;
    const auto numbers = finiteNumbers(row, 1, 12, file, kLayout);
    if (!numbers) return numbers.error();
    const auto& v = numbers.value();
    return Projection{{0, 0, v[0], v[5], v[2], v[6]}, v[0] != 0 ? -v[3] / v[0] : 0};
  }
  return inputError("there is no line " + name, file.string(), kLayout);
}

/// Rows are frames: the number in an image's name says which row is its own. Empty if the names
/// hold no numbers.
std::vector<std::size_t> numbersOf(const std::vector<fs::path>& images) {
  std::vector<std::size_t> numbers;
  for (const fs::path& image : images) {
    const std::string stem = image.stem().string();
    if (stem.empty() || stem.size() > 9 || stem.find_first_not_of("0123456789") != stem.npos)
      return {};
    numbers.push_back(std::stoul(stem));
  }
  return numbers;
}

/// Row of times.txt (and poses.txt) for each image.
Result<std::vector<std::size_t>> rowsOf(const std::vector<fs::path>& images, std::size_t times,
                                        const fs::path& file) {
  std::vector<std::size_t> rows = numbersOf(images);
  if (!rows.empty() && rows.back() < times) return rows;
  if (images.size() != times)
    return inputError(
        std::to_string(times) + " times for " + std::to_string(images.size()) + " images",
        file.string(),
        "name the images by their row in times.txt (000000.png, 000001.png, ...), or "
        "leave one row per image");
  rows.resize(images.size());
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = i;
  return rows;
}

struct KittiImages {
  std::vector<ImageEntry> entries;
  std::vector<std::size_t> rows;  ///< of each entry
  std::size_t times = 0;          ///< rows of times.txt
};

Result<KittiImages> listImages(const fs::path& folder, const std::string& name) {
  const auto images = sortedImages(folder / name);
  if (images.empty()) return inputError("there are no images", (folder / name).string(), kLayout);
  const fs::path file = folder / "times.txt";
  const auto lines = readTextRows(file, kLayout);
  if (!lines) return lines.error();
  const auto rows = rowsOf(images, lines.value().size(), file);
  if (!rows) return rows.error();
  KittiImages result;
  result.rows = rows.value();
  result.times = lines.value().size();
  for (size_t i = 0; i < images.size(); ++i) {
    const TextRow& line = lines.value()[result.rows[i]];
    const auto stamp = finiteNumbers(line, 0, 1, file, kLayout);
    if (!stamp) return stamp.error();
    if (i > 0 && stamp.value()[0] <= result.entries.back().timestamp)
      return inputError("time does not increase", place(file, line.line),
                        "times.txt holds one increasing time per image");
    result.entries.push_back({stamp.value()[0], images[i], {}});
  }
  return result;
}

/// Poses by row, like the times. Their number must be that of the times: else nobody knows which
/// pose belongs to which image, and a wrong pairing looks like a bad trajectory.
Status attachPoses(const fs::path& folder, const KittiImages& images, double offset_m,
                   ImageList& list) {
  const fs::path full = fs::weakly_canonical(folder);
  for (const fs::path& file :
       {full / "poses.txt", full / ".." / ".." / "poses" / (folderName(folder) + ".txt")}) {
    if (!fs::exists(file)) continue;
    const auto poses = loadTrajectory(file);
    if (!poses) {
      list.notes.push_back("the ground truth is not used: " + poses.error().message());
      return Done{};
    }
    if (poses.value().poses.size() != images.times)
      return inputError(std::to_string(poses.value().poses.size()) + " poses for " +
                            std::to_string(images.times) + " times",
                        file.string(),
                        "cut both files to the same frames, or move the poses away to run without "
                        "ground truth");
    const SE3 T_left_cam(Eigen::Quaterniond::Identity(), Vec3(offset_m, 0, 0));
    for (size_t i = 0; i < images.rows.size(); ++i)
      list.truth.push_back({list.entries[i].timestamp,
                            poses.value().poses[images.rows[i]].T_world_cam * T_left_cam});
    return Done{};
  }
  return Done{};
}

/// The resolution is that of the first image, as calib.txt does not state it.
Result<double> findCamera(const fs::path& folder, const OpenOptions& options,
                          const std::string& row, ImageList& list) {
  const ImageSize size = sizeOfImage(list.entries[0].image);
  if (!options.camera.empty()) {
    const auto read = readCalibration(options.camera, size);
    if (!read) return read.error();
    list.camera = read.value().camera;
    list.camera_source = options.camera.string();
    return 0.0;
  }
  const fs::path calib = folder / "calib.txt";
  const auto projection = readProjection(calib, row);
  if (!projection) return projection.error();
  const auto first = readImageFile(list.entries[0].image, cv::IMREAD_GRAYSCALE);
  if (!first) return first.error();
  list.camera.pinhole = projection.value().pinhole;
  list.camera.pinhole.width = size.width;
  list.camera.pinhole.height = size.height;
  list.camera_source = list.entries[0].image.string();
  const Status status = list.camera.check();
  if (!status) return inputError(status.error().what, calib.string(), kLayout);
  const Status plausible = plausibleIntrinsics(list.camera.pinhole, calib.string());
  if (!plausible) return plausible.error();
  return projection.value().offset_m;
}

bool isKitti(const fs::path& folder) {
  const bool lists = fs::exists(folder / "times.txt") && fs::exists(folder / "calib.txt");
  return lists || fs::is_directory(folder / "image_0");
}

OpenedSequence openFolder(const fs::path& folder, const OpenOptions& options) {
  const KittiCamera which = cameraOf(folder);
  ImageList list;
  list.name = folderName(folder);
  auto images = listImages(folder, which.images);
  if (!images) return images.error();
  list.entries = images.value().entries;
  const auto offset = findCamera(folder, options, which.row, list);
  if (!offset) return offset.error();
  list.camera.rate_hz = medianRate(list.entries);
  const Status posed = attachPoses(folder, images.value(), offset.value(), list);
  if (!posed) return posed.error();
  return ListSequence::open(std::move(list));
}

}  // namespace

/// A folder like sequences/00: image_0/ with P0 of calib.txt, or image_2/ with P2, and times.txt;
/// optional poses.txt there or ../../poses/00.txt (poses of the left grey camera). Images, times
/// and poses are paired by the number in the image's name.
Loader kittiLoader() {
  return {Loader::Takes::folder, "image_0/ (KITTI odometry)", isKitti, openFolder};
}

}  // namespace svoscope
