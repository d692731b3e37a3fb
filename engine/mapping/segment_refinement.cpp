// SPDX-License-Identifier: MIT
#include "engine/mapping/segment_refinement.h"

#include <Eigen/LU>
#include <cmath>

#include "engine/geometry/segment.h"

namespace svoscope {

namespace {

constexpr double kRobust = 3;  // residuals beyond, in sigmas, pull no stronger (Huber)

/// Two directions at right angles to the segment.
Eigen::Matrix<double, 3, 2> basisAcross(const Vec3& along) {
  Eigen::Matrix<double, 3, 2> B;
  B.col(0) = along.unitOrthogonal();
  B.col(1) = along.cross(B.col(0)).normalized();
  return B;
}

double weightOf(double r) { return std::abs(r) <= kRobust ? 1.0 : kRobust / std::abs(r); }

double costOf(const EndPointResiduals& e) {
  if (!e.valid) return 1e300;
  double cost = 0;
  for (Eigen::Index i = 0; i < e.r.size(); ++i) {
    const double a = std::abs(e.r[i]);
    cost += a <= kRobust ? a * a : kRobust * (2 * a - kRobust);
  }
  return cost;
}

}  // namespace

EndPointResiduals endPointResiduals(const SegmentLandmark& segment, int end, const Vec3& p_world,
                                    const Map& map, double line_noise_px) {
  EndPointResiduals out;
  const auto most = static_cast<Eigen::Index>(segment.views.size()) + 1;
  out.r.resize(most);
  out.J.resize(most, 3);
  Eigen::Index n = 0;
  for (const SegmentView& view : segment.views) {
    const auto it = map.keyframes.find(view.keyframe_id);
    if (it == map.keyframes.end()) continue;
    const SE3& T = it->second.T_cam_world;
    const Vec3 p = T * p_world;
    if (p.z() < 1e-3) {
      // A long segment may reach behind a later camera: that view says nothing about this end.
      if (&view != &segment.views.front()) continue;
      out.valid = false;
      return out;
    }
    const Vec2 px = map.camera.project(p);
    const ImageLine line = lineThrough(view.anchor.px[0], view.anchor.px[1]);
    const double sigma = line_noise_px * (1 << view.anchor.level) *
                         std::sqrt(lineVariance(view.anchor.px[0], view.anchor.px[1], px));
    out.r[n] = line.distance(px) / sigma;
    out.J.row(n++) = linePointJacobian(map.camera, p, T.rotation(), line.normal) / sigma;
  }
  const auto owner = segment.views.empty() ? map.keyframes.end()
                                           : map.keyframes.find(segment.views.front().keyframe_id);
  if (segment.prior_sigma[end] > 0 && owner != map.keyframes.end()) {
    // Depth along the first view's ray; the inverse distance of a point near that ray.
    const SE3& T = owner->second.T_cam_world;
    const Vec3& f = segment.views.front().anchor.f[end];
    const double depth = f.dot(T * p_world);
    if (depth > 1e-3) {
      out.r[n] = (1 / depth - segment.prior[end]) / segment.prior_sigma[end];
      out.J.row(n++) = -(f.transpose() * T.rotation()) / (depth * depth * segment.prior_sigma[end]);
    }
  }
  out.r.conservativeResize(n);
  out.J.conservativeResize(n, 3);
  return out;
}

bool refineSegment(SegmentLandmark& segment, const Map& map, double line_noise_px,
                   int max_iterations) {
  if (segment.views.size() < 2) return false;
  const auto B = basisAcross((segment.p_world[1] - segment.p_world[0]).normalized());
  bool moved = false;
  for (int end = 0; end < 2; ++end) {
    Vec3 p = segment.p_world[end];
    EndPointResiduals now = endPointResiduals(segment, end, p, map, line_noise_px);
    double cost = costOf(now);
    Mat2 H = Mat2::Zero();
    for (int it = 0; it <= max_iterations && now.valid; ++it) {
      H = 1e-9 * Mat2::Identity();
      Vec2 b = Vec2::Zero();
      for (Eigen::Index i = 0; i < now.r.size(); ++i) {
        const Eigen::RowVector2d j = now.J.row(i) * B;
        const double w = weightOf(now.r[i]);
        H += w * j.transpose() * j;
        b -= w * now.r[i] * j.transpose();
      }
      if (it == max_iterations) break;
      const Vec2 step = H.inverse() * b;
      if (!step.allFinite()) break;
      const EndPointResiduals next =
          endPointResiduals(segment, end, p + B * step, map, line_noise_px);
      const double next_cost = costOf(next);
      // A view that dropped out would lower the cost by itself.
      if (next.r.size() != now.r.size() || !(next_cost < cost)) break;
      const bool done = cost - next_cost < 1e-6 * cost;
      p += B * step;
      now = next;
      cost = next_cost;
      moved = true;
      if (done) break;
    }
    segment.p_world[end] = p;
    const Mat2 C = H.inverse();
    if (C.allFinite()) segment.covariance[end] = B * C * B.transpose();
  }
  return moved;
}

Mat3 seedEndCovariance(const SegmentSeed& seed, int end, const SE3& T_cam_world) {
  const double mu = seed.belief[end].mu;
  const Vec3 g = T_cam_world.quaternion().conjugate() * (seed.anchor.f[end] / (mu * mu));
  return seed.belief[end].sigma2 * g * g.transpose();
}

}  // namespace svoscope
