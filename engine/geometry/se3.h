// SPDX-License-Identifier: MIT
// Rigid motions. T_a_b maps coordinates of frame b into frame a: p_a = T_a_b * p_b.
#pragma once

#include "engine/base/types.h"

namespace svoscope {

/// Skew-symmetric matrix: hat(a) * b == a.cross(b).
Mat3 hat(const Vec3& v);

/// Rotation of a rotation vector (axis times angle, radians) and its inverse.
Eigen::Quaterniond so3Exp(const Vec3& omega);
Vec3 so3Log(const Eigen::Quaterniond& q);

/// Element of SE(3). Tangent vectors are ordered (translation, rotation), metres and radians.
class SE3 {
 public:
  SE3() : q_(Eigen::Quaterniond::Identity()), t_(Vec3::Zero()) {}
  SE3(const Eigen::Quaterniond& q, const Vec3& t) : q_(q.normalized()), t_(t) {}
  SE3(const Mat3& R, const Vec3& t) : q_(Eigen::Quaterniond(R).normalized()), t_(t) {}

  /// Parts that came out of an SE3, taken over bit by bit: the quaternion is not normalized again.
  static SE3 fromParts(const Eigen::Quaterniond& unit, const Vec3& t) {
    SE3 T;
    T.q_ = unit;
    T.t_ = t;
    return T;
  }
  /// Exponential map of the twist (v, omega).
  static SE3 exp(const Vec6& twist);
  /// Inverse of exp for rotation angles below pi.
  Vec6 log() const;

  SE3 inverse() const {
    const Eigen::Quaterniond qi = q_.conjugate();
    return SE3(qi, -(qi * t_));
  }
  SE3 operator*(const SE3& o) const { return SE3(q_ * o.q_, t_ + q_ * o.t_); }
  Vec3 operator*(const Vec3& p) const { return q_ * p + t_; }

  const Eigen::Quaterniond& quaternion() const { return q_; }
  Mat3 rotation() const { return q_.toRotationMatrix(); }
  const Vec3& translation() const { return t_; }
  Mat4 matrix() const;
  bool finite() const { return q_.coeffs().allFinite() && t_.allFinite(); }

 private:
  Eigen::Quaterniond q_;
  Vec3 t_;
};

}  // namespace svoscope
