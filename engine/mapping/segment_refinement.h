// SPDX-License-Identifier: MIT
#pragma once

#include "engine/mapping/map.h"

namespace svoscope {

/// Gauss-Newton on both end points of a segment over the lines of its keyframes and what its seed
/// knew. An end point moves at right angles to the segment only: where along the line it lies is a
/// convention. Undone if the error rises. Fills the covariances; returns true if it moved.
bool refineSegment(SegmentLandmark& segment, const Map& map, double line_noise_px,
                   int max_iterations);

/// Residuals of one end point: distances from the lines of the views (px / line_noise, longer
/// extrapolation weighing less), then the seed's depth. Jacobian: d residual / d end point.
struct EndPointResiduals {
  Eigen::VectorXd r;
  Eigen::Matrix<double, Eigen::Dynamic, 3> J;
  bool valid = true;  ///< in front of all views
};
EndPointResiduals endPointResiduals(const SegmentLandmark& segment, int end, const Vec3& p_world,
                                    const Map& map, double line_noise_px);

/// Covariance of a seed's end point in the world: its depth alone is uncertain.
Mat3 seedEndCovariance(const SegmentSeed& seed, int end, const SE3& T_cam_world);

}  // namespace svoscope
