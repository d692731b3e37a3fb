// SPDX-License-Identifier: MIT
// Camera poses in metres for the depth study.
#include <algorithm>

#include "engine/eval/estimate.h"
#include "engine/eval/evaluate.h"
#include "engine/study/depth_study.h"

namespace svoscope {

std::vector<std::optional<SE3>> groundTruthPoses(const Sequence& sequence, double max_gap) {
  const Trajectory& truth = sequence.groundTruth();
  std::vector<std::optional<SE3>> poses(static_cast<std::size_t>(sequence.size()));
  constexpr double kSame = 1e-4;  // s: stamps written with four decimals
  for (int i = 0; i < sequence.size() && !truth.empty(); ++i) {
    const double t = sequence.timestamp(i);
    const auto after =
        std::lower_bound(truth.begin(), truth.end(), t,
                         [](const StampedPose& p, double time) { return p.timestamp < time; });
    std::optional<SE3>& pose = poses[static_cast<std::size_t>(i)];
    if (after != truth.end() && after->timestamp - t < kSame) {
      pose = after->T_world_cam;
    } else if (after == truth.begin() || after == truth.end()) {
      const StampedPose& end = after == truth.end() ? truth.back() : truth.front();
      if (std::abs(end.timestamp - t) < kSame) pose = end.T_world_cam;
    } else {
      const StampedPose &a = *(after - 1), &b = *after;
      const double gap = b.timestamp - a.timestamp;
      if (gap > max_gap) continue;
      const double part = (t - a.timestamp) / gap;
      pose =
          SE3(a.T_world_cam.quaternion().slerp(part, b.T_world_cam.quaternion()),
              Vec3((1 - part) * a.T_world_cam.translation() + part * b.T_world_cam.translation()));
    }
  }
  return poses;
}

Result<std::vector<std::optional<SE3>>> alignedPoses(const Sequence& sequence,
                                                     const std::vector<FrameRecord>& records) {
  const int map_id = mainMap(records);
  const Trajectory estimate = estimateOf(records);
  const auto aligned = evaluate(sequence.groundTruth(), estimate);
  if (!aligned.ok()) return aligned.error();
  std::vector<std::optional<SE3>> poses(static_cast<std::size_t>(sequence.size()));
  for (const FrameRecord& r : records) {
    if (hasPoseIn(r, map_id) && r.index >= 0 && r.index < sequence.size())
      poses[static_cast<std::size_t>(r.index)] = aligned.value().T_gt_est * r.T_world_cam;
  }
  return poses;
}

}  // namespace svoscope
