// SPDX-License-Identifier: MIT
#include "engine/dataset/ground_truth.h"

#include <algorithm>

#include "engine/base/text_rows.h"

namespace svoscope {
namespace {

namespace fs = std::filesystem;

const char* const kTumLayout = "a TUM trajectory has lines 'timestamp tx ty tz qx qy qz qw'";
const char* const kEurocLayout =
    "an ASL ground truth has lines 'timestamp [ns],px,py,pz,qw,qx,qy,qz,...'";
const char* const kKittiLayout = "KITTI poses have 12 numbers a line, the 3x4 matrix [R t]";

Result<SE3> poseOf(const Eigen::Quaterniond& q, const Vec3& t, const fs::path& file, int line,
                   const char* layout) {
  if (q.norm() < 1e-6) return inputError("the quaternion has norm zero", place(file, line), layout);
  return SE3(q, t);
}

Result<Trajectory> sorted(Trajectory trajectory, const fs::path& file, const char* layout) {
  if (trajectory.empty()) return inputError("the file holds no pose", file.string(), layout);
  std::stable_sort(
      trajectory.begin(), trajectory.end(),
      [](const StampedPose& a, const StampedPose& b) { return a.timestamp < b.timestamp; });
  return trajectory;
}

}  // namespace

Result<Trajectory> readTumTrajectory(const fs::path& file) {
  const auto rows = readTextRows(file, kTumLayout);
  if (!rows) return rows.error();
  Trajectory trajectory;
  trajectory.reserve(rows.value().size());
  for (const TextRow& row : rows.value()) {
    const auto numbers = finiteNumbers(row, 0, 8, file, kTumLayout);
    if (!numbers) return numbers.error();
    const auto& v = numbers.value();
    const auto pose = poseOf(Eigen::Quaterniond(v[7], v[4], v[5], v[6]), Vec3(v[1], v[2], v[3]),
                             file, row.line, kTumLayout);
    if (!pose) return pose.error();
    trajectory.push_back({v[0], pose.value()});
  }
  return sorted(std::move(trajectory), file, kTumLayout);
}

Result<Trajectory> readEurocTrajectory(const fs::path& file) {
  const auto rows = readTextRows(file, kEurocLayout);
  if (!rows) return rows.error();
  Trajectory trajectory;
  trajectory.reserve(rows.value().size());
  for (const TextRow& row : rows.value()) {
    const auto stamp = parseNanoseconds(row.fields[0]);
    if (!stamp)
      return inputError("'" + row.fields[0] + "' is not a time in whole nanoseconds",
                        place(file, row.line), kEurocLayout);
    const auto numbers = finiteNumbers(row, 1, 7, file, kEurocLayout);
    if (!numbers) return numbers.error();
    const auto& v = numbers.value();
    const auto pose = poseOf(Eigen::Quaterniond(v[3], v[4], v[5], v[6]), Vec3(v[0], v[1], v[2]),
                             file, row.line, kEurocLayout);
    if (!pose) return pose.error();
    trajectory.push_back({*stamp, pose.value()});
  }
  return sorted(std::move(trajectory), file, kEurocLayout);
}

Result<std::vector<SE3>> readKittiPoses(const fs::path& file) {
  const auto rows = readTextRows(file, kKittiLayout);
  if (!rows) return rows.error();
  std::vector<SE3> poses;
  poses.reserve(rows.value().size());
  for (const TextRow& row : rows.value()) {
    const auto numbers = finiteNumbers(row, 0, 12, file, kKittiLayout);
    if (!numbers) return numbers.error();
    const auto& v = numbers.value();
    Mat3 R;
    R << v[0], v[1], v[2], v[4], v[5], v[6], v[8], v[9], v[10];
    if (!(R * R.transpose()).isIdentity(1e-2) || R.determinant() < 0)
      return inputError("the left 3x3 part is not a rotation", place(file, row.line), kKittiLayout);
    poses.emplace_back(R, Vec3(v[3], v[7], v[11]));
  }
  if (poses.empty()) return inputError("the file holds no pose", file.string(), kKittiLayout);
  return poses;
}

}  // namespace svoscope
