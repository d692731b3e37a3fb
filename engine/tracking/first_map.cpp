// SPDX-License-Identifier: MIT
#include "engine/tracking/first_map.h"

#include "engine/match/patch.h"
#include "engine/tracking/frame_summary.h"
#include "engine/tracking/relocalizer.h"

namespace svoscope {

namespace {

Keyframe& addReference(const InitializerOutput& start, Map& map) {
  Keyframe& ref = map.keyframes[map.next_keyframe_id];
  ref.id = map.next_keyframe_id++;
  ref.frame_index = start.reference_index;
  ref.timestamp = start.reference_timestamp;
  ref.pyramid = start.reference_pyramid;
  ref.thumbnail = makeThumbnail(*ref.pyramid);
  return ref;
}

/// The point as a landmark of the reference and as a feature of the frame.
TrackedFeature addPoint(const InitializerPoint& p, const SE3& T_cur_ref, Keyframe& ref, Map& map) {
  const FeatureAnchor anchor{p.px_ref, map.camera.bearing(p.px_ref), p.level, p.type,
                             p.gradient_dir};
  Landmark& landmark = map.addLandmark(p.p_ref, p.type);
  landmark.sigma = p.sigma_inv_depth;
  map.addObservation(landmark, ref, anchor);
  TrackedFeature f;
  f.origin = FeatureOrigin::landmark;
  f.id = landmark.id;
  f.keyframe_id = ref.id;
  f.anchor = {p.px_cur, map.camera.bearing(p.px_cur), p.level, p.type, Vec2::Zero()};
  if (p.type == FeatureType::edgelet) {
    const Mat2 A = affineWarp(map.camera, T_cur_ref, anchor.f, p.p_ref.norm());
    f.anchor.gradient_dir = (A.inverse().transpose() * p.gradient_dir).normalized();
  }
  f.p_world = p.p_ref;
  f.predicted_px = map.camera.project(T_cur_ref * p.p_ref);
  f.error_px = (f.predicted_px - f.anchor.px).norm();
  return f;
}

}  // namespace

int buildFirstMap(const InitializerOutput& start, Map& map, Frame& frame) {
  Keyframe& ref = addReference(start, map);
  frame.T_cam_world = start.T_cur_ref;
  for (const InitializerPoint& p : start.points) {
    if ((start.T_cur_ref * p.p_ref).z() <= 0 || !map.camera.inside(p.px_cur, 1)) continue;
    frame.features.push_back(addPoint(p, start.T_cur_ref, ref, map));
  }
  depthStatistics(frame, ref.median_depth, ref.min_depth);
  return ref.id;
}

}  // namespace svoscope
