// SPDX-License-Identifier: MIT
// One try to register a frame; internal to the tracker.
#pragma once

#include <string>

#include "engine/tracking/tracker.h"

namespace svoscope {

inline double& stageMs(FrameRecord& record, Stage s) {
  return record.time_ms[static_cast<std::size_t>(s)];
}

struct Tracker::Attempt {
  const char* from = "";
  SparseAlignmentResult aligned;
  ReprojectionResult reprojected;
  SegmentTrackingResult segments;
  PoseRefinementResult pose;
  SE3 T_cam_world;
  std::string failure;  ///< empty if accepted
};

}  // namespace svoscope
