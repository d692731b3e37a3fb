// SPDX-License-Identifier: MIT
// Segments of the nearby keyframes in the current frame: projected, clipped, aligned, turned into
// observations for the pose and into patches for the next sparse image alignment.
#pragma once

#include <vector>

#include "engine/mapping/seed_update.h"
#include "engine/tracking/frame.h"
#include "engine/tracking/segment_pose.h"
#include "engine/tracking/sparse_alignment.h"

namespace svoscope {

struct SegmentTrackingResult {
  std::vector<TrackedSegment> segments;  ///< aligned
  std::vector<TrackedSegment> failed;    ///< tried without success
  int candidates = 0, projected = 0, tried = 0;
};

/// `frame` brings pyramid and predicted pose.
SegmentTrackingResult trackSegments(const Map& map, const Frame& frame,
                                    const std::vector<int>& local_keyframes,
                                    const MappingParameters& parameters);

/// Both ends of a seed in the world, at its current means.
void setSeedPose(const SegmentSeed& seed, const Keyframe& keyframe, TrackedSegment& segment);

/// Residuals with sigmas that hold the line's noise and the end points' depth, at the pose given.
std::vector<SegmentPoseObservation> segmentObservations(const Pinhole& camera,
                                                        const std::vector<TrackedSegment>& segments,
                                                        const SE3& T_cam_world,
                                                        const SegmentParameters& parameters);

/// Appends up to `count` patches evenly spaced between the points p0 and p1 (camera frame) of a
/// segment: as with points, the direction measured in the image, the distance of the map.
void appendPatchesAlong(const Pinhole& camera, const Vec3& p0, const Vec3& p1,
                        const ImageLine& line, int count, std::vector<AlignmentPatch>& patches);

/// Appends patches along the frame's inlier segments.
void appendSegmentPatches(const Pinhole& camera, const Frame& frame,
                          const SegmentParameters& parameters,
                          std::vector<AlignmentPatch>& patches);

}  // namespace svoscope
