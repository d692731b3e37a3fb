// SPDX-License-Identifier: MIT
// Pose from the aligned features: robust reprojection error, points in 2-D, edgelets along their
// gradient (1-D), segments across their line (segment_pose.h).
#pragma once

#include <vector>

#include "engine/base/kinds.h"
#include "engine/geometry/camera.h"
#include "engine/geometry/se3.h"
#include "engine/tracking/segment_pose.h"

namespace svoscope {

struct PoseRefinementParameters {
  int max_iterations = 10;
  double max_error_px = 2;     ///< features above are outliers; times 2^level
  double edgelet_sigma = 2;    ///< noise of an edgelet relative to a corner
  double min_scale_px = 0.15;  ///< floor of the robust scale
};

struct PoseObservation {
  Vec2 px = Vec2::Zero();  ///< measured, level 0
  Vec3 p_world = Vec3::Zero();
  int level = 0;
  FeatureType type = FeatureType::corner;
  Vec2 gradient_dir = Vec2::Zero();  ///< edgelets, unit
  /// One sigma of the point's depth in the image. The covariance of the error is that of the pixel
  /// noise plus depth_px depth_px^T: a seed of unknown depth informs the pose across its epipolar
  /// line only.
  Vec2 depth_px = Vec2::Zero();
};

struct PoseRefinementResult {
  bool ok = false;
  SE3 T_cam_world;
  Mat6 information = Mat6::Zero();  ///< of a left twist, in units of the robust scale
  double scale_px = 0;              ///< robust scale, level-0 px
  double median_px = 0;             ///< median error of inliers, level-0 px
  std::vector<double>
      error_px;  ///< per observation, level-0 px; what the depth's doubt does not explain
  std::vector<char> inlier;  ///< per observation
  int inliers = 0;
  double segment_scale = 0;              ///< robust scale of the segments, times line_noise_px
  std::vector<double> segment_error_px;  ///< per segment, root mean square of both ends
  std::vector<char> segment_inlier;
  int segment_inliers = 0;
};

/// Tukey-weighted Gauss-Newton (c = 4.685) from T_init; the scale is 1.48 x the median of the
/// level-normalised errors.
PoseRefinementResult refinePose(const Pinhole& camera,
                                const std::vector<PoseObservation>& observations, const SE3& T_init,
                                const PoseRefinementParameters& parameters,
                                const std::vector<SegmentPoseObservation>& segments = {},
                                const SegmentParameters& segment_parameters = {});

}  // namespace svoscope
