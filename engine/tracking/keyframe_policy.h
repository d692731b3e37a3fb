// SPDX-License-Identifier: MIT
// When to take a keyframe: when tracked landmarks run out, not when the camera has moved a fixed
// share of the depth (docs/method.md, "Keyframes").
#pragma once

#include <string>

#include "engine/geometry/se3.h"

namespace svoscope {

struct KeyframeParameters {
  int enough_landmarks = 120;  ///< above: no keyframe
  int few_landmarks = 70;      ///< below: keyframe at once, unless the camera stands:
  double still_px = 4;         ///< median displacement below, px at 640 px width ...
  double still_distance =
      0.01;            ///< ... and translation to a local keyframe over median depth below
  int min_frames = 2;  ///< since the last keyframe
  double min_displacement_px = 40;  ///< median displacement of shared landmarks, px at 640 px width
  double min_angle_deg = 20;        ///< or at least this rotation ...
  double min_distance =
      0.1;                 ///< ... or this translation over median depth, to every local keyframe
  int max_keyframes = 60;  ///< in the map; beyond, the farthest is removed
};

/// What the decision looks at.
struct KeyframeEvidence {
  int landmarks = 0;  ///< inlier landmarks in the frame
  int inliers = 0;    ///< all inliers
  int required = 0;   ///< inliers below which tracking is lost
  int frames_since_last = 0;
  double displacement_px = 0;  ///< median, landmarks shared with the last keyframe; px at 640 width
  bool shares_landmarks = false;
  double nearest_distance = 0;   ///< to the closest local keyframe / median depth
  double nearest_angle_deg = 0;  ///< rotation to that keyframe
};

struct KeyframeDecision {
  bool take = false;
  std::string reason;
};

KeyframeDecision decideKeyframe(const KeyframeEvidence& evidence,
                                const KeyframeParameters& parameters);

}  // namespace svoscope
