// SPDX-License-Identifier: MIT
// A segment found in the current frame.
#pragma once

#include "engine/mapping/segment_seed.h"

namespace svoscope {

struct TrackedSegment {
  FeatureOrigin origin = FeatureOrigin::landmark;
  std::int64_t id = -1;                              ///< segment landmark or segment seed
  int keyframe_id = -1;                              ///< reference view of the patches
  SegmentAnchor anchor;                              ///< measured: visible part on the fitted line
  Vec2 predicted[2] = {Vec2::Zero(), Vec2::Zero()};  ///< that part before alignment
  Vec3 p_world[2] = {Vec3::Zero(), Vec3::Zero()};    ///< both ends of the segment
  Mat3 covariance[2] = {Mat3::Zero(), Mat3::Zero()};
  double t[2] = {0, 1};  ///< visible part in space
  FeatureStatus status = FeatureStatus::inlier;
  bool informs = false;  ///< entered the pose; others are followed for their depth
  double error_px = 0;   ///< root mean square of both distances after pose refinement

  Vec3 pointAt(double u) const { return (1 - u) * p_world[0] + u * p_world[1]; }
};

}  // namespace svoscope
