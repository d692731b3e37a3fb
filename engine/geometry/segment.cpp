// SPDX-License-Identifier: MIT
#include "engine/geometry/segment.h"

#include <algorithm>
#include <cmath>

namespace svoscope {

namespace {
constexpr double kNear = 1e-3;  // least depth of a visible point, map units

/// Keeps the part of [t0, t1] where value0 + t (value1 - value0) >= 0.
bool clipHalf(double value0, double value1, double& t0, double& t1) {
  const double slope = value1 - value0;
  if (std::abs(slope) < 1e-15) return value0 >= 0;
  const double t = -value0 / slope;
  slope > 0 ? t0 = std::max(t0, t) : t1 = std::min(t1, t);
  return t0 < t1;
}
}  // namespace

ImageLine lineThrough(const Vec2& a, const Vec2& b) {
  ImageLine line;
  const Vec2 d = (b - a).normalized();
  line.normal = Vec2(-d.y(), d.x());
  line.offset = line.normal.dot(0.5 * (a + b));
  return line;
}

double lineVariance(const Vec2& a, const Vec2& b, const Vec2& at) {
  const double u = (at - a).dot(b - a) / std::max((b - a).squaredNorm(), 1e-12);
  return (1 - u) * (1 - u) + u * u;
}

Vec3 linePlane(const Pinhole& c, const ImageLine& l) {
  return {l.normal.x() * c.fx, l.normal.y() * c.fy,
          l.normal.x() * c.cx + l.normal.y() * c.cy - l.offset};
}

bool clipToImage(const Pinhole& c, const Vec3& p0, const Vec3& p1, double border, double& t0,
                 double& t1) {
  t0 = 0;
  t1 = 1;
  // Each side of the image is a plane through the camera centre.
  const Vec3 sides[4] = {{c.fx, 0, c.cx - border},
                         {-c.fx, 0, c.width - 1 - border - c.cx},
                         {0, c.fy, c.cy - border},
                         {0, -c.fy, c.height - 1 - border - c.cy}};
  if (!clipHalf(p0.z() - kNear, p1.z() - kNear, t0, t1)) return false;
  return std::all_of(std::begin(sides), std::end(sides), [&](const Vec3& side) {
    return clipHalf(side.dot(p0), side.dot(p1), t0, t1);
  });
}

Row6 lineTwistJacobian(const Pinhole& camera, const Vec3& p, const Vec2& normal) {
  const Row3 across = normal.transpose() * camera.projectJacobian(p);
  Row6 J;
  J << across, -across * hat(p);
  return J;
}

Row3 linePointJacobian(const Pinhole& camera, const Vec3& p, const Mat3& R_cam_world,
                       const Vec2& normal) {
  return normal.transpose() * camera.projectJacobian(p) * R_cam_world;
}

RayLineIntersection intersectRayLine(const Pinhole& camera, const SE3& T_cur_ref, const Vec3& f_ref,
                                     const ImageLine& line) {
  RayLineIntersection out;
  const Vec3 m = linePlane(camera, line);
  const Vec3 a = T_cur_ref.quaternion() * f_ref;
  const Vec3& t = T_cur_ref.translation();
  const double mt = m.dot(t), ma = m.dot(a);
  if (std::abs(mt) < 1e-12) return out;
  // The point at inverse distance z has the direction a + z t; the plane wants m . (a + z t) = 0.
  out.inv_distance = -ma / mt;
  out.per_px = std::abs((a.z() * mt - ma * t.z()) / (mt * mt));
  const Vec3 q = a + out.inv_distance * t;
  if (q.z() < kNear) {
    out.inv_distance = -1;
    return out;
  }
  const Vec2 along = camera.projectJacobian(q) * t;
  out.cosine = along.norm() > 1e-12 ? std::abs(line.normal.dot(along.normalized())) : 0;
  return out;
}

bool sameEdge(const Vec2 (&a)[2], const Vec2 (&b)[2], double max_angle_deg, double distance_px,
              double overlap) {
  const double la = (a[1] - a[0]).norm(), lb = (b[1] - b[0]).norm();
  if (la < 1e-9 || lb < 1e-9) return false;
  const Vec2 da = (a[1] - a[0]) / la, db = (b[1] - b[0]) / lb;
  if (std::abs(da.dot(db)) < std::cos(max_angle_deg * M_PI / 180.0)) return false;
  const bool a_longer = la >= lb;
  const auto& longer = a_longer ? a : b;
  const auto& shorter = a_longer ? b : a;
  const Vec2 d = a_longer ? da : db;
  if (std::abs(lineThrough(longer[0], longer[1]).distance(0.5 * (shorter[0] + shorter[1]))) >
      distance_px)
    return false;
  const double s0 = d.dot(shorter[0] - longer[0]), s1 = d.dot(shorter[1] - longer[0]);
  const double common =
      std::min(std::max(s0, s1), std::max(la, lb)) - std::max(std::min(s0, s1), 0.0);
  return common >= overlap * std::min(la, lb);
}

}  // namespace svoscope
