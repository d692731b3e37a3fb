// SPDX-License-Identifier: MIT
// A trajectory: time-stamped camera poses, sorted by time.
#pragma once

#include <vector>

#include "engine/geometry/se3.h"

namespace svoscope {

struct StampedPose {
  double timestamp = 0;  ///< s
  SE3 T_world_cam;       ///< camera to world, m
};

using Trajectory = std::vector<StampedPose>;

}  // namespace svoscope
