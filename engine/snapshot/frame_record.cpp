// SPDX-License-Identifier: MIT
#include "engine/snapshot/frame_record.h"

namespace svoscope {

const char* stageName(Stage stage) {
  static constexpr const char* kNames[kStageCount] = {
      "read",      "rectify",  "pyramid",    "initialize", "sparse_align", "reproject", "pose",
      "structure", "keyframe", "relocalize", "tracking",   "mapping",      "snapshot"};
  return kNames[static_cast<int>(stage)];
}

const char* stateName(TrackingState state) {
  switch (state) {
    case TrackingState::initializing:
      return "initializing";
    case TrackingState::tracking:
      return "tracking";
    case TrackingState::lost:
      return "lost";
  }
  return "unknown";
}

}  // namespace svoscope
