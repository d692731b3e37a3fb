// SPDX-License-Identifier: MIT
// Poses that follow from an essential matrix or a homography.
#pragma once

#include <vector>

#include "engine/geometry/se3.h"

namespace svoscope {

/// A pose and the plane n . p_ref = 1 (n of unit length, t in units of the plane's distance).
struct PlanePose {
  SE3 T_cur_ref;
  Vec3 n_ref = Vec3::Zero();
};

/// The four solutions of H ~ R + t n^T (Ma, Soatto, Kosecka, Sastry: An Invitation to 3-D Vision,
/// section 5.3.3). H as from fitHomography: middle singular value 1, det H > 0. Empty if H is a
/// rotation.
std::vector<PlanePose> decomposeHomography(const Mat3& H_cur_ref);

/// The four poses (|t| = 1) of an essential matrix.
std::vector<SE3> decomposeEssential(const Mat3& E_cur_ref);

/// E with x_cur^T E x_ref = 0.
Mat3 essentialMatrix(const SE3& T_cur_ref);

}  // namespace svoscope
