// SPDX-License-Identifier: MIT
// What a registered frame amounts to: depths and counts for its record.
#pragma once

#include "engine/snapshot/frame_record.h"
#include "engine/tracking/frame.h"

namespace svoscope {

/// Median and 5 % quantile of the depth (z) of the frame's inliers; false if there are none.
bool depthStatistics(const Frame& frame, double& median, double& near);

/// Adds to the record of a frame its pose, its inliers by kind, their median error and depth, and
/// the size of the map.
void summarizeFrame(const Frame& frame, const Map& map, FrameRecord& record);

}  // namespace svoscope
