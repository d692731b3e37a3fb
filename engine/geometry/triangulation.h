// SPDX-License-Identifier: MIT
// A point from its views. Image positions are on the plane z = 1 of each camera.
#pragma once

#include <vector>

#include "engine/geometry/se3.h"

namespace svoscope {

/// A point on the ray of the reference position, by two views.
struct TwoRayPoint {
  double inv_depth = 0;   ///< 1 / z in the reference camera, 1 / unit of t; not positive: behind
  double sigma = 0;       ///< of inv_depth for an error of 1 on the unit plane of cur
  double error = 0;       ///< distance of x_cur from the projected point, unit plane
  double parallax = 0;    ///< angle between the two rays, radians
  bool in_front = false;  ///< z > 0 in both cameras

  /// The point in the reference camera's frame; only for inv_depth > 0.
  Vec3 point(const Vec2& x_ref) const { return x_ref.homogeneous() / inv_depth; }
};

/// Triangulates with the reference position taken as exact, as it is for a patch cut out there:
/// the point of the epipolar line nearest to x_cur.
TwoRayPoint triangulate(const SE3& T_cur_ref, const Vec2& x_ref, const Vec2& x_cur);

/// Angle between the rays of x_ref and x_cur once both are in one frame, radians.
double parallaxAngle(const SE3& T_cur_ref, const Vec2& x_ref, const Vec2& x_cur);

/// One view of a point for refinePoint.
struct PointView {
  SE3 T_cam_world;
  Vec2 x = Vec2::Zero();  ///< unit plane
  double weight = 1;      ///< inverse variance, any common unit
};

struct RefinedPoint {
  Vec3 p_world = Vec3::Zero();
  double rms = 0;  ///< weighted, unit plane
  int iterations = 0;
  bool converged = false;  ///< false: behind a camera, or the normal equations are singular
};

/// Gauss-Newton on the weighted reprojection error of all views; a step that does not lower the
/// error is undone and ends the refinement.
RefinedPoint refinePoint(const Vec3& p_world, const std::vector<PointView>& views,
                         int max_iterations = 10);

/// d (p / z) / d p for a point p in the camera frame.
Mat23 unitPlaneJacobian(const Vec3& p);

}  // namespace svoscope
