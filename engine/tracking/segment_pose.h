// SPDX-License-Identifier: MIT
// Segments in pose refinement: distance of two points of a segment from the observed line, each
// with the Jacobian of its own depth; a robust scale of their own, as their errors are of another
// kind than those of points.
#pragma once

#include <vector>

#include "engine/geometry/segment.h"
#include "engine/mapping/segment_seed.h"

namespace svoscope {

struct SegmentPoseObservation {
  Vec3 p_world[2] = {Vec3::Zero(), Vec3::Zero()};  ///< ends of the visible part
  ImageLine line;                                  ///< measured
  double sigma[2] = {1, 1};  ///< of the distances relative to line_noise_px: line and depth
  bool informs = true;       ///< false: followed for its depth only, not used for the pose
};

/// Signed distances, px; false if an end is behind the camera.
bool segmentResiduals(const Pinhole& camera, const SegmentPoseObservation& o,
                      const SE3& T_cam_world, double (&e)[2]);

/// 1.48 x median of |distance| / sigma of those that inform, at least `min_scale`.
double segmentScale(const Pinhole& camera, const std::vector<SegmentPoseObservation>& observations,
                    const SE3& T_cam_world, double min_scale);

/// Adds the segments' Tukey-weighted terms to H and b of H step = b (left twist).
void addSegmentTerms(const Pinhole& camera, const std::vector<SegmentPoseObservation>& observations,
                     const SE3& T_cam_world, double scale, double pose_sigma, Mat6& H, Vec6& b);

}  // namespace svoscope
