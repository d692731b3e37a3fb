// SPDX-License-Identifier: MIT
#include "engine/geometry/se3.h"

#include <cmath>

namespace svoscope {

namespace {
// Below this squared angle the series are exact to double precision.
constexpr double kSmallAngleSquared = 1e-8;
}  // namespace

Mat3 hat(const Vec3& v) {
  Mat3 m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

Eigen::Quaterniond so3Exp(const Vec3& omega) {
  const double theta2 = omega.squaredNorm();
  double s = 0.5 - theta2 / 48.0;  // sin(theta / 2) / theta
  double c = 1.0 - theta2 / 8.0;
  if (theta2 > kSmallAngleSquared) {
    const double theta = std::sqrt(theta2);
    s = std::sin(0.5 * theta) / theta;
    c = std::cos(0.5 * theta);
  }
  return Eigen::Quaterniond(c, s * omega.x(), s * omega.y(), s * omega.z()).normalized();
}

Vec3 so3Log(const Eigen::Quaterniond& q) {
  const double sign = q.w() < 0 ? -1.0 : 1.0;
  const Vec3 v = sign * q.vec();
  const double w = sign * q.w();
  const double n = v.norm();
  if (n * n < kSmallAngleSquared) return 2.0 * v / w;
  return 2.0 * std::atan2(n, w) / n * v;
}

SE3 SE3::exp(const Vec6& twist) {
  const Vec3 v = twist.head<3>();
  const Vec3 w = twist.tail<3>();
  const double theta2 = w.squaredNorm();
  double a = 0.5 - theta2 / 24.0;         // (1 - cos) / theta^2
  double b = 1.0 / 6.0 - theta2 / 120.0;  // (theta - sin) / theta^3
  if (theta2 > kSmallAngleSquared) {
    const double theta = std::sqrt(theta2);
    a = (1.0 - std::cos(theta)) / theta2;
    b = (theta - std::sin(theta)) / (theta2 * theta);
  }
  const Vec3 wv = w.cross(v);
  return SE3(so3Exp(w), v + a * wv + b * w.cross(wv));
}

Vec6 SE3::log() const {
  const Vec3 w = so3Log(q_);
  const double theta2 = w.squaredNorm();
  double c = 1.0 / 12.0 + theta2 / 720.0;
  if (theta2 > kSmallAngleSquared) {
    const double theta = std::sqrt(theta2);
    const double half = 0.5 * theta;
    c = (1.0 - half * std::cos(half) / std::sin(half)) / theta2;
  }
  const Vec3 wt = w.cross(t_);
  Vec6 out;
  out << t_ - 0.5 * wt + c * w.cross(wt), w;
  return out;
}

Mat4 SE3::matrix() const {
  Mat4 m = Mat4::Identity();
  m.topLeftCorner<3, 3>() = rotation();
  m.topRightCorner<3, 1>() = t_;
  return m;
}

}  // namespace svoscope
