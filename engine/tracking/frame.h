// SPDX-License-Identifier: MIT
// The current frame and what is tracked in it.
#pragma once

#include <vector>

#include "engine/mapping/map.h"
#include "engine/tracking/tracked_segment.h"

namespace svoscope {

struct TrackedFeature {
  FeatureOrigin origin = FeatureOrigin::landmark;
  std::int64_t id = -1;              ///< landmark or seed
  int keyframe_id = -1;              ///< reference view of the patch
  FeatureAnchor anchor;              ///< measured in this frame
  Vec2 predicted_px = Vec2::Zero();  ///< where it was projected before alignment
  Vec3 p_world = Vec3::Zero();
  Vec3 p_believed =
      Vec3::Zero();              ///< seeds: where the belief had it before this frame; else p_world
  Vec2 depth_px = Vec2::Zero();  ///< seeds: how far one sigma of that belief moves its projection
  FeatureStatus status = FeatureStatus::inlier;
  double error_px = 0;  ///< reprojection error after pose refinement
};

struct Frame {
  int index = -1;
  double timestamp = 0;
  PyramidPtr pyramid;
  SE3 T_cam_world;
  double noise_px = 0;  ///< robust scale of its features' errors: blur and rolling shutter raise it
  std::vector<TrackedFeature> features;
  std::vector<TrackedSegment> segments;
};

}  // namespace svoscope
