// SPDX-License-Identifier: MIT
// A textured wall, a map of it with exact landmarks, and frames that look at it: the parts of the
// tracker are tested on it without a run.
#pragma once

#include "engine/tracking/frame.h"
#include "engine/tracking/relocalizer.h"
#include "tests/support/plane_scene.h"

namespace svoscope::test {

struct TrackedWall {
  static constexpr int kLevels = 4;

  PlaneScene scene{smallCamera(), Vec3::UnitZ(), 2, 0.09};
  Map map;

  /// Keyframes 0 .. n - 1, 1.2 m apart, each with landmarks of its own.
  explicit TrackedWall(int keyframes = 1) {
    map.camera = scene.camera();
    for (int i = 0; i < keyframes; ++i) addKeyframe(shifted(-1.2 * i));
  }

  static SE3 shifted(double x, double y = 0, double z = 0) {
    return SE3(Eigen::Quaterniond::Identity(), Vec3(x, y, z));
  }

  Keyframe& addKeyframe(const SE3& T_cam_world) {
    const int id = map.next_keyframe_id++;
    Keyframe& k = map.keyframes[id];
    k.id = k.frame_index = id;
    k.T_cam_world = T_cam_world;
    k.pyramid = scene.pyramid(T_cam_world, kLevels);
    k.thumbnail = makeThumbnail(*k.pyramid);
    for (const Vec2& px : gridPixels(map.camera, 24, 30)) {
      Landmark& landmark = map.addLandmark(scene.point(T_cam_world, px), FeatureType::corner);
      map.addObservation(landmark, k, anchor(px));
    }
    return k;
  }

  FeatureAnchor anchor(const Vec2& px) const {
    FeatureAnchor a;
    a.px = px;
    a.f = map.camera.bearing(px);
    return a;
  }

  /// A frame that is not registered yet.
  Frame frame(int index, const SE3& T_cam_world) const {
    Frame f;
    f.index = index;
    f.pyramid = scene.pyramid(T_cam_world, kLevels);
    return f;
  }

  /// A frame at the pose of a keyframe that has found all of its landmarks.
  Frame registered(int index, const Keyframe& k) const {
    Frame f = frame(index, k.T_cam_world);
    f.T_cam_world = k.T_cam_world;
    for (const std::int64_t id : k.landmarks) {
      const Landmark& landmark = *map.find(id);
      TrackedFeature t;
      t.id = id;
      t.keyframe_id = k.id;
      t.anchor = landmark.observations.front().anchor;
      t.p_world = t.p_believed = landmark.p_world;
      f.features.push_back(t);
    }
    return f;
  }
};

}  // namespace svoscope::test
