// SPDX-License-Identifier: MIT
#include "engine/dataset/truth.h"

#include "engine/eval/trajectory_file.h"

namespace svoscope {

void attachTruth(const std::filesystem::path& file, const std::optional<SE3>& T_body_cam,
                 ImageList& list) {
  std::error_code ec;
  if (!std::filesystem::exists(file, ec)) return;
  auto read = loadTrajectory(file);
  if (!read) {
    list.notes.push_back("the ground truth is not used: " + read.error().message());
    return;
  }
  TrajectoryFile& truth = read.value();
  for (const std::string& warning : truth.warnings) list.notes.push_back(warning);
  if (truth.positions_only && T_body_cam) {
    list.notes.push_back(file.string() +
                         ": positions without orientation stay those of the body, the camera is "
                         "beside it");
  }
  for (StampedPose& pose : truth.poses) {
    if (T_body_cam && !truth.positions_only) pose.T_world_cam = pose.T_world_cam * *T_body_cam;
  }
  list.truth = std::move(truth.poses);
}

}  // namespace svoscope
