// SPDX-License-Identifier: MIT
#include "engine/geometry/two_view_decompose.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace svoscope {

Mat3 essentialMatrix(const SE3& T_cur_ref) {
  return hat(T_cur_ref.translation()) * T_cur_ref.rotation();
}

std::vector<SE3> decomposeEssential(const Mat3& E_cur_ref) {
  const Eigen::JacobiSVD<Mat3> svd(E_cur_ref, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Mat3 U = svd.matrixU(), V = svd.matrixV();
  if (U.determinant() < 0) U.col(2) = -U.col(2);
  if (V.determinant() < 0) V.col(2) = -V.col(2);
  Mat3 W;
  W << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  const Vec3 t = U.col(2);
  std::vector<SE3> out;
  for (const Mat3& R : {Mat3(U * W * V.transpose()), Mat3(U * W.transpose() * V.transpose())}) {
    out.emplace_back(R, t);
    out.emplace_back(R, -t);
  }
  return out;
}

std::vector<PlanePose> decomposeHomography(const Mat3& H_cur_ref) {
  const Eigen::SelfAdjointEigenSolver<Mat3> eigen(H_cur_ref.transpose() * H_cur_ref);
  // Largest first, as in the book; V a rotation.
  const double s1 = eigen.eigenvalues()[2], s3 = eigen.eigenvalues()[0];
  Mat3 V = eigen.eigenvectors().rowwise().reverse();
  if (V.determinant() < 0) V = -V;
  if (s1 - s3 < 1e-9) return {};
  const double a = std::sqrt(std::max(0.0, 1 - s3)), b = std::sqrt(std::max(0.0, s1 - 1));
  const double c = std::sqrt(s1 - s3);
  std::vector<PlanePose> out;
  for (const double sign : {1.0, -1.0}) {
    // u and v2 span the plane's tangent directions whose lengths H keeps.
    const Vec3 v2 = V.col(1);
    const Vec3 u = (a * V.col(0) + sign * b * V.col(2)) / c;
    const Vec3 n = v2.cross(u);
    Mat3 U, W;
    U << v2, u, n;
    const Vec3 hv = H_cur_ref * v2, hu = H_cur_ref * u;
    W << hv, hu, hv.cross(hu);
    const Mat3 R = W * U.transpose();
    const Vec3 t = (H_cur_ref - R) * n;
    out.push_back({SE3(R, t), n});
    out.push_back({SE3(R, -t), -n});
  }
  return out;
}

}  // namespace svoscope
