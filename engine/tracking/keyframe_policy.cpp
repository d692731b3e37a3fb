// SPDX-License-Identifier: MIT
#include "engine/tracking/keyframe_policy.h"

#include <fmt/format.h>

namespace svoscope {

KeyframeDecision decideKeyframe(const KeyframeEvidence& e, const KeyframeParameters& p) {
  if (e.landmarks > p.enough_landmarks)
    return {false, fmt::format("{} landmarks > {}", e.landmarks, p.enough_landmarks)};
  if (e.frames_since_last < p.min_frames)
    return {false, fmt::format("{} frames since the last < {}", e.frames_since_last, p.min_frames)};
  // Where texture is scarce, a keyframe at the same place finds no more landmarks than the last
  // did; one in every other frame would push the map that is left out of the limit of keyframes.
  const bool stands =
      e.shares_landmarks && e.displacement_px < p.still_px && e.nearest_distance < p.still_distance;
  if (stands) {
    return {false, fmt::format("stands: moved {:.1f} px and {:.3f} of the depth since a keyframe",
                               e.displacement_px, e.nearest_distance)};
  }
  if (e.landmarks < p.few_landmarks)
    return {true, fmt::format("{} landmarks < {}", e.landmarks, p.few_landmarks)};
  if (e.shares_landmarks && e.displacement_px < p.min_displacement_px)
    return {false, fmt::format("moved {:.0f} px < {:.0f} since the last", e.displacement_px,
                               p.min_displacement_px)};
  if (e.nearest_distance < p.min_distance && e.nearest_angle_deg < p.min_angle_deg)
    return {false, fmt::format("a keyframe lies within {:.3f} of the depth and {:.0f} degrees",
                               e.nearest_distance, e.nearest_angle_deg)};
  return {true, fmt::format("{} landmarks <= {}, moved {:.0f} px", e.landmarks, p.enough_landmarks,
                            e.displacement_px)};
}

}  // namespace svoscope
