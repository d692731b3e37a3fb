// SPDX-License-Identifier: MIT
#include "app/eval_input.h"

#include <filesystem>

#include "app/command.h"
#include "engine/dataset/calibration/calibration.h"
#include "engine/dataset/sequence.h"
#include "engine/eval/conventions.h"

namespace svoscope {

namespace {

Result<TrajectoryFile> load(const std::string& file, TrajectoryUse use, bool w_first) {
  TrajectoryReading reading;
  reading.use = use;
  reading.quaternion = w_first ? QuaternionOrder::wxyz : QuaternionOrder::xyzw;
  auto loaded = loadTrajectory(file, reading);
  if (loaded.ok()) {
    for (const std::string& warning : loaded.value().warnings) reportWarning(warning);
  }
  return loaded;
}

/// The ground truth of a sequence, brought to its camera by its loader.
Result<TrajectoryFile> truthOfSequence(const std::string& path) {
  const auto opened = openSequence(path);
  if (!opened.ok()) return opened.error();
  for (const std::string& text : opened.value()->notes()) reportWarning(text);
  TrajectoryFile file;
  file.poses = opened.value()->groundTruth();
  if (file.poses.empty())
    return inputError("the sequence has no ground truth", path, "give a trajectory file");
  return file;
}

bool isSequence(const std::string& path) {
  std::error_code ec;
  return path.rfind("synthetic:", 0) == 0 || std::filesystem::is_directory(path, ec);
}

Status moveToCamera(const std::string& path, const std::string& extrinsics, TrajectoryFile& file) {
  if (extrinsics.empty()) {
    if (file.format == TrajectoryFormat::euroc)
      reportWarning(
          path +
          ": an EuRoC ground truth is of the body (IMU), the estimate of the camera: give "
          "the sequence's folder, or --extrinsics FILE");
    return Done{};
  }
  if (file.positions_only)
    return usageError("positions without orientation cannot be moved to the camera", "--extrinsics",
                      "leave it out; the error then holds the lever arm");
  const auto T_body_cam = readExtrinsics(extrinsics);
  if (!T_body_cam.ok()) return T_body_cam.error();
  for (StampedPose& pose : file.poses) pose.T_world_cam = pose.T_world_cam * T_body_cam.value();
  return Done{};
}

}  // namespace

Result<TrajectoryFile> loadGroundTruth(const std::string& path,
                                       const EvalConventions& conventions) {
  if (isSequence(path)) {
    if (!conventions.extrinsics.empty())
      return usageError("the sequence brings its own extrinsics", "--extrinsics",
                        "give the ground truth's file instead of the folder");
    return truthOfSequence(path);
  }
  const std::string& order = conventions.quaternion;
  auto file = load(path, TrajectoryUse::ground_truth, order == "wxyz" || order == "gt-wxyz");
  if (!file.ok()) return file;
  const Status moved = moveToCamera(path, conventions.extrinsics, file.value());
  if (!moved.ok()) return moved.error();
  return file;
}

Result<TrajectoryFile> loadEstimate(const std::string& path, const EvalConventions& conventions) {
  const std::string& order = conventions.quaternion;
  auto file = load(path, TrajectoryUse::estimate, order == "wxyz" || order == "est-wxyz");
  if (!file.ok()) return file;
  if (conventions.invert) file.value().poses = invertedPoses(file.value().poses);
  if (conventions.mirror) file.value().poses = mirroredPoses(file.value().poses);
  return file;
}

}  // namespace svoscope
