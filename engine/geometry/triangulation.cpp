// SPDX-License-Identifier: MIT
#include "engine/geometry/triangulation.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>

namespace svoscope {

namespace {

/// Weighted sum of squared errors; infinite if the point is behind a camera.
double cost(const Vec3& p_world, const std::vector<PointView>& views) {
  double sum = 0;
  for (const PointView& view : views) {
    const Vec3 p = view.T_cam_world * p_world;
    if (p.z() <= 0) return std::numeric_limits<double>::infinity();
    sum += view.weight * (view.x - p.hnormalized()).squaredNorm();
  }
  return sum;
}

}  // namespace

Mat23 unitPlaneJacobian(const Vec3& p) {
  const double iz = 1.0 / p.z();
  Mat23 J;
  J << iz, 0, -p.x() * iz * iz, 0, iz, -p.y() * iz * iz;
  return J;
}

double parallaxAngle(const SE3& T_cur_ref, const Vec2& x_ref, const Vec2& x_cur) {
  const Vec3 a = T_cur_ref.quaternion() * x_ref.homogeneous();
  const Vec3 b = x_cur.homogeneous();
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

TwoRayPoint triangulate(const SE3& T_cur_ref, const Vec2& x_ref, const Vec2& x_cur) {
  // A point of inverse depth rho projects to pi(a + rho t). Multiplying by the denominator makes
  // the condition linear: rho (x t_z - t_xy) = a_xy - x a_z. With x replaced by its foot on the
  // epipolar line (direction a x t) this is exact, not an algebraic approximation.
  const Vec3 a = T_cur_ref.quaternion() * x_ref.homogeneous();
  const Vec3& t = T_cur_ref.translation();
  TwoRayPoint out;
  out.parallax = parallaxAngle(T_cur_ref, x_ref, x_cur);
  const Vec3 line = t.cross(a);
  const double norm2 = line.head<2>().squaredNorm();
  if (norm2 <= 0) {
    out.sigma = std::numeric_limits<double>::infinity();
    return out;
  }
  const Vec2 foot = x_cur - line.head<2>() * (line.dot(x_cur.homogeneous()) / norm2);
  const Vec2 d = foot * t.z() - t.head<2>();
  const Vec2 c = a.head<2>() - foot * a.z();
  const double d2 = d.squaredNorm();
  out.inv_depth = d.dot(c) / d2;
  const Vec3 q = a + out.inv_depth * t;
  out.sigma = std::abs(q.z()) / std::sqrt(d2);
  out.in_front = out.inv_depth > 0 && q.z() > 0;
  out.error = (foot - x_cur).norm();
  return out;
}

RefinedPoint refinePoint(const Vec3& p_world, const std::vector<PointView>& views,
                         int max_iterations) {
  RefinedPoint out;
  out.p_world = p_world;
  double best = cost(p_world, views);
  if (views.empty() || !std::isfinite(best)) return out;
  for (; out.iterations < max_iterations && !out.converged; ++out.iterations) {
    Mat3 H = Mat3::Zero();
    Vec3 b = Vec3::Zero();
    for (const PointView& view : views) {
      const Vec3 p = view.T_cam_world * out.p_world;
      const Mat23 J = unitPlaneJacobian(p) * view.T_cam_world.rotation();
      H += view.weight * J.transpose() * J;
      b += view.weight * J.transpose() * (view.x - p.hnormalized());
    }
    const Eigen::LDLT<Mat3> ldlt(H);
    const Vec3 step = ldlt.solve(b);
    if (ldlt.info() != Eigen::Success || !step.allFinite()) return out;
    const double next = cost(out.p_world + step, views);
    out.converged = next >= best || step.norm() < 1e-12 * out.p_world.norm();
    if (next >= best) break;
    out.p_world += step;
    best = next;
  }
  out.converged = true;
  double weights = 0;
  for (const PointView& view : views) weights += view.weight;
  out.rms = std::sqrt(best / weights);
  return out;
}

}  // namespace svoscope
