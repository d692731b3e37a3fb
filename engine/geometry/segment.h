// SPDX-License-Identifier: MIT
// Lines in the image and segments in space. An image line is an infinite line: how far an end point
// lies along it says nothing, only the distance across it is measured.
#pragma once

#include "engine/geometry/camera.h"
#include "engine/geometry/se3.h"

namespace svoscope {

using Row3 = Eigen::Matrix<double, 1, 3>;
using Row6 = Eigen::Matrix<double, 1, 6>;

/// normal . px = offset, level-0 px; the normal has unit length.
struct ImageLine {
  Vec2 normal = Vec2::UnitX();
  double offset = 0;

  /// Signed distance of a pixel, px.
  double distance(const Vec2& px) const { return normal.dot(px) - offset; }
  Vec2 closest(const Vec2& px) const { return px - distance(px) * normal; }
};

ImageLine lineThrough(const Vec2& a, const Vec2& b);

/// Variance of the line through two pixels at the pixel `at`, in units of the variance of one of
/// the pixels across the line: 1 at the ends, 1/2 in the middle, growing outside.
double lineVariance(const Vec2& a, const Vec2& b, const Vec2& at);

/// Plane through the camera centre and the line: m . p / p.z is the distance in px of the
/// projection of p (camera frame) from the line.
Vec3 linePlane(const Pinhole& camera, const ImageLine& line);

/// Part of the segment p0 + t (p1 - p0), camera frame, that is in front of the camera and projects
/// at least `border` px inside the image: t in [t0, t1]. False if there is none.
bool clipToImage(const Pinhole& camera, const Vec3& p0, const Vec3& p1, double border, double& t0,
                 double& t1);

/// d distance / d left twist of the camera (translation, rotation), px; p in the camera frame.
Row6 lineTwistJacobian(const Pinhole& camera, const Vec3& p, const Vec2& normal);
/// d distance / d point in the world, px per map unit; p in the camera frame.
Row3 linePointJacobian(const Pinhole& camera, const Vec3& p, const Mat3& R_cam_world,
                       const Vec2& normal);

/// Where the ray of an end point meets the plane of the line observed in another view.
struct RayLineIntersection {
  double inv_distance = 0;  ///< along the unit bearing; not positive: no intersection in front
  double per_px = 0;        ///< |d inv_distance| per px of error across the line
  double cosine = 0;  ///< of the angle between epipolar line and line normal; 0: no measurement
};
RayLineIntersection intersectRayLine(const Pinhole& camera, const SE3& T_cur_ref, const Vec3& f_ref,
                                     const ImageLine& line);

/// Whether two segments show the same edge: nearly parallel, closer than `distance_px` across, and
/// overlapping along for at least `overlap` of the shorter one.
bool sameEdge(const Vec2 (&a)[2], const Vec2 (&b)[2], double max_angle_deg, double distance_px,
              double overlap);

}  // namespace svoscope
