// SPDX-License-Identifier: MIT
#include "engine/io/trajectory_writer.h"

#include <fmt/format.h>

#include <cmath>

#include "engine/io/text_output.h"

namespace svoscope {

std::string tumLine(const StampedPose& pose) {
  const Vec3& t = pose.T_world_cam.translation();
  const Eigen::Quaterniond& q = pose.T_world_cam.quaternion();
  return fmt::format("{:.6f} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g}", pose.timestamp,
                     t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w());
}

Status writeTumTrajectory(const std::filesystem::path& file, const Trajectory& poses) {
  std::string text = std::string(kTumHeader) + "\n";
  for (const StampedPose& pose : poses) text += tumLine(pose) + "\n";
  return writeWhole(file, text);
}

Status writeEurocTrajectory(const std::filesystem::path& file, const Trajectory& poses) {
  std::string text = "#timestamp [ns],p_x [m],p_y [m],p_z [m],q_w,q_x,q_y,q_z\n";
  for (const StampedPose& pose : poses) {
    const Vec3& t = pose.T_world_cam.translation();
    const Eigen::Quaterniond& q = pose.T_world_cam.quaternion();
    // Microseconds first: the double holds no more digits at today's epoch.
    text += fmt::format("{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n",
                        std::llround(pose.timestamp * 1e6) * 1000, t.x(), t.y(), t.z(), q.w(),
                        q.x(), q.y(), q.z());
  }
  return writeWhole(file, text);
}

Status writeKittiTrajectory(const std::filesystem::path& file, const Trajectory& poses) {
  std::string text;
  for (const StampedPose& pose : poses) {
    const Mat4 T = pose.T_world_cam.matrix();
    for (int i = 0; i < 12; ++i) {
      text += fmt::format("{:.9g}{}", T(i / 4, i % 4), i == 11 ? "\n" : " ");
    }
  }
  return writeWhole(file, text);
}

}  // namespace svoscope
