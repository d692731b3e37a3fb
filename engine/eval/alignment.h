// SPDX-License-Identifier: MIT
// Least-squares alignment of two point sets in closed form (Umeyama, IEEE PAMI 13(4), 1991).
#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/geometry/se3.h"

namespace svoscope {

enum class Alignment { none, se3, sim3 };
const char* alignmentName(Alignment alignment);  ///< "none", "se3", "sim3"
Result<Alignment> parseAlignment(const std::string& name);

/// Similarity: p_a = scale * R_a_b * p_b + t_a_b.
struct Sim3 {
  double scale = 1;
  SE3 T;  ///< rotation, and the translation after scaling

  Vec3 operator*(const Vec3& p) const { return T * Vec3(scale * p); }
  /// Moves a pose given in frame b into frame a.
  SE3 operator*(const SE3& pose) const {
    return SE3(T.quaternion() * pose.quaternion(), *this * pose.translation());
  }
};

/// The S that minimises sum |target_i - S * source_i|^2; scale 1 unless sim3, identity for none.
/// Points on a line leave the rotation about it open: any of the equally good ones is returned, and
/// `straight` (if given) set. Input error if fewer than three points, or if one set lies in a
/// point.
Result<Sim3> alignPoints(const std::vector<Vec3>& source, const std::vector<Vec3>& target,
                         Alignment alignment, bool* straight = nullptr);

}  // namespace svoscope
