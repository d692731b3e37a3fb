// SPDX-License-Identifier: MIT
#include "engine/eval/estimate.h"

#include <map>

namespace svoscope {

namespace {

/// Good poses by map id.
std::map<int, int> posesByMap(const std::vector<FrameRecord>& records) {
  std::map<int, int> poses;
  for (const FrameRecord& r : records) {
    if (hasPoseIn(r, r.map_id)) ++poses[r.map_id];
  }
  return poses;
}

}  // namespace

bool hasPoseIn(const FrameRecord& record, int map_id) {
  return record.pose_good && record.map_id == map_id && record.T_world_cam.finite();
}

int mainMap(const std::vector<FrameRecord>& records) {
  int best = -1, most = 0;
  for (const auto& [id, poses] : posesByMap(records)) {
    if (poses < most) continue;
    best = id;
    most = poses;
  }
  return best;
}

int mapCount(const std::vector<FrameRecord>& records) {
  return static_cast<int>(posesByMap(records).size());
}

Trajectory estimateOf(const std::vector<FrameRecord>& records) {
  const int map_id = mainMap(records);
  Trajectory estimate;
  for (const FrameRecord& r : records) {
    if (hasPoseIn(r, map_id)) estimate.push_back({r.timestamp, r.T_world_cam});
  }
  return estimate;
}

}  // namespace svoscope
