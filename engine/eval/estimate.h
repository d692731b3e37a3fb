// SPDX-License-Identifier: MIT
// The trajectory of a run. A map that is given up takes its frame of reference and its scale with
// it: poses of different maps do not belong into one trajectory.
#pragma once

#include <vector>

#include "engine/geometry/trajectory.h"
#include "engine/snapshot/frame_record.h"

namespace svoscope {

/// Id of the map with most good poses, the later of equals; -1: there is no good pose.
int mainMap(const std::vector<FrameRecord>& records);

/// Number of maps with a good pose.
int mapCount(const std::vector<FrameRecord>& records);

/// The pose is good and finite, and given in the world of map `map_id`.
bool hasPoseIn(const FrameRecord& record, int map_id);

/// Poses of the main map.
Trajectory estimateOf(const std::vector<FrameRecord>& records);

}  // namespace svoscope
