// SPDX-License-Identifier: MIT
#include "engine/match/patch.h"

#include <Eigen/LU>

#include "engine/frame/pyramid.h"

namespace svoscope {

Mat2 affineWarp(const Pinhole& camera, const SE3& T_cur_ref, const Vec3& f_ref, double distance) {
  // Closed form of the derivative of "unproject onto the plane through the point, parallel to the
  // reference image; transform; project".
  const Mat3 R = T_cur_ref.rotation();
  const Vec3 p_ref = f_ref * distance;
  const Vec3 p_cur = R * p_ref + T_cur_ref.translation();
  const Mat23 J = camera.projectJacobian(p_cur);
  const double z = p_ref.z();
  Eigen::Matrix<double, 3, 2> dp;
  dp.col(0) = R.col(0) * (z / camera.fx);
  dp.col(1) = R.col(1) * (z / camera.fy);
  return J * dp;
}

int searchLevel(const Mat2& A_cur_ref, int level_ref, int max_level) {
  int level = 0;
  const double area_ref = static_cast<double>(1 << level_ref) * (1 << level_ref);
  double area = A_cur_ref.determinant() * area_ref;
  while (area > 3.0 && level < max_level) {
    ++level;
    area *= 0.25;
  }
  return level;
}

bool warpPatch(const cv::Mat& image_ref, const Vec2& px_ref, int level_ref, const Mat2& A_cur_ref,
               int level_cur, WarpedPatch& patch) {
  const double det = A_cur_ref.determinant();
  if (!(std::abs(det) > 1e-6)) return false;
  const Vec2 center = toLevel(px_ref, level_ref);
  const double scale = static_cast<double>(1 << level_cur) / (1 << level_ref);
  const Eigen::Matrix2f A = (A_cur_ref.inverse() * scale).cast<float>();
  const auto cx = static_cast<float>(center.x()), cy = static_cast<float>(center.y());
  // The farthest corner decides whether all samples are inside.
  const float reach = kPatchHalf + 1;
  const float rx = reach * (std::abs(A(0, 0)) + std::abs(A(0, 1)));
  const float ry = reach * (std::abs(A(1, 0)) + std::abs(A(1, 1)));
  if (!(cx - rx >= 0) || !(cy - ry >= 0) || !(cx + rx < static_cast<float>(image_ref.cols - 1)) ||
      !(cy + ry < static_cast<float>(image_ref.rows - 1)))
    return false;
  float* out = patch.bordered.data();
  for (int i = 0; i < kBorderedSize; ++i) {
    const auto v = static_cast<float>(i - kPatchHalf - 1);
    for (int j = 0; j < kBorderedSize; ++j) {
      const auto u = static_cast<float>(j - kPatchHalf - 1);
      *out++ = bilinear(image_ref, cx + A(0, 0) * u + A(0, 1) * v, cy + A(1, 0) * u + A(1, 1) * v);
    }
  }
  return true;
}

}  // namespace svoscope
