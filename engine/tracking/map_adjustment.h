// SPDX-License-Identifier: MIT
// Taking over a local adjustment: what it refined, and what hangs on the keyframes it moved.
#pragma once

#include <optional>

#include "engine/mapping/local_adjustment.h"
#include "engine/mapping/map.h"
#include "engine/tracking/frame.h"

namespace svoscope {

/// How the surroundings of a keyframe changed: old camera coordinates times `scale`, seen from the
/// new pose.
struct KeyframeChange {
  SE3 T_cam_world_old, T_cam_world_new;
  double scale = 1;

  Vec3 moved(const Vec3& p_world) const {
    return T_cam_world_new.inverse() * (scale * (T_cam_world_old * p_world));
  }
  /// T_cam_world of another camera that goes along.
  SE3 followed(const SE3& T_cam_world) const {
    const SE3 T_cam_kf = T_cam_world * T_cam_world_old.inverse();
    return SE3(T_cam_kf.quaternion(), scale * T_cam_kf.translation()) * T_cam_world_new;
  }
};

/// Takes over refined poses, points and segments; seeds and the current frame follow their
/// keyframes, so that frame and map stay consistent. Returns the change of the newest keyframe,
/// which the frame went along with; nothing if the adjustment has no say.
std::optional<KeyframeChange> adoptAdjustment(const AdjustmentResult& adjustment,
                                              const SegmentParameters& segments,
                                              int structure_iterations, Map& map, Frame& frame);

}  // namespace svoscope
