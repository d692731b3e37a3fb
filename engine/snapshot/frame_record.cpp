// SPDX-License-Identifier: MIT
#include "engine/snapshot/frame_record.h"

namespace svoscope {

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
