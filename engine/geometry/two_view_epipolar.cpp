// SPDX-License-Identifier: MIT
// Relative pose by the epipolar constraint: five-point search and non-linear refinement.
#include <Eigen/Cholesky>
#include <cmath>
#include <opencv2/calib3d.hpp>

#include "engine/geometry/triangulation.h"
#include "engine/geometry/two_view_decompose.h"
#include "engine/geometry/two_view_models.h"
#include "engine/geometry/two_view_sampling.h"

namespace svoscope {

namespace {

using Vec5 = Eigen::Matrix<double, 5, 1>;
using Mat5 = Eigen::Matrix<double, 5, 5>;

/// e / |gradient of e|: the first-order distance in the four image coordinates, times sqrt(2) to
/// be comparable with a distance in one image.
double sampson(const Mat3& E, const Vec2& x_ref, const Vec2& x_cur, double* denominator = nullptr) {
  const Vec3 l_cur = E * x_ref.homogeneous();
  const Vec3 l_ref = E.transpose() * x_cur.homogeneous();
  const double norm2 =
      0.5 * (l_cur.head<2>().squaredNorm() + l_ref.head<2>().squaredNorm()) + 1e-24;
  if (denominator) *denominator = norm2;
  return l_cur.dot(x_cur.homogeneous()) / std::sqrt(norm2);
}

double cauchyCost(const SE3& T, const TwoViewData& data) {
  const double c2 = 4 * data.sigma * data.sigma;
  double sum = 0;
  for (double e : epipolarErrors(T, data)) sum += std::log1p(e * e / c2);
  return sum;
}

/// Two directions orthogonal to the unit vector t: the tangent of the sphere.
Eigen::Matrix<double, 3, 2> sphereTangent(const Vec3& t) {
  Eigen::Matrix<double, 3, 2> B;
  B.col(0) = t.unitOrthogonal();
  B.col(1) = t.cross(B.col(0));
  return B;
}

/// Normal equations over (rotation, tangent of t), weights and Sampson denominators held.
void normalEquations(const SE3& T, const TwoViewData& data, Mat5& H, Vec5& b) {
  H.setZero();
  b.setZero();
  const Mat3 E = essentialMatrix(T);
  const Mat3 R = T.rotation();
  const Vec3& t = T.translation();
  const auto B = sphereTangent(t);
  const double c2 = 4 * data.sigma * data.sigma;
  for (int i = 0; i < data.size(); ++i) {
    double norm2 = 0;
    const double r = sampson(E, data.x_ref[i], data.x_cur[i], &norm2);
    const double weight = 1 / (1 + r * r / c2) / norm2;
    const Vec3 a = R * data.x_ref[i].homogeneous();
    const Vec3 x = data.x_cur[i].homogeneous();
    // e = x . (t x a); a turns with the rotation: de = w . (a x (x x t)); de = dt . (a x x).
    Vec5 J;
    J << a.cross(x.cross(t)), B.transpose() * a.cross(x);
    H += weight * J * J.transpose();
    b -= weight * J * x.dot(t.cross(a));
  }
}

/// Of the poses that share this epipolar geometry, the one with most points in front.
SE3 mostInFront(const Mat3& E, const TwoViewData& data, const std::vector<int>& sample) {
  SE3 best;
  int best_count = -1;
  for (const SE3& T : decomposeEssential(E)) {
    int count = 0;
    for (int i : sample) count += triangulate(T, data.x_ref[i], data.x_cur[i]).in_front;
    if (count > best_count) {
      best_count = count;
      best = T;
    }
  }
  return best;
}

/// Five-point solutions (Nister 2004): with exactly five points the library solves them and draws
/// nothing at random.
std::vector<SE3> fivePoint(const TwoViewData& data, const std::vector<int>& sample) {
  std::vector<cv::Point2d> ref, cur;
  for (int i : sample) {
    ref.emplace_back(data.x_ref[i].x(), data.x_ref[i].y());
    cur.emplace_back(data.x_cur[i].x(), data.x_cur[i].y());
  }
  const cv::Mat E = cv::findEssentialMat(ref, cur, cv::Matx33d::eye(), cv::RANSAC, 0.999, 1.0);
  std::vector<SE3> poses;
  for (int k = 0; k + 3 <= E.rows; k += 3) {
    Mat3 M;
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) M(r, c) = E.at<double>(k + r, c);
    if (M.allFinite()) poses.push_back(mostInFront(M, data, sample));
  }
  return poses;
}

}  // namespace

std::vector<double> epipolarErrors(const SE3& T_cur_ref, const TwoViewData& data) {
  const Mat3 E = essentialMatrix(T_cur_ref);
  std::vector<double> errors(data.size());
  for (int i = 0; i < data.size(); ++i)
    errors[i] = std::abs(sampson(E, data.x_ref[i], data.x_cur[i]));
  return errors;
}

std::vector<bool> inFront(const SE3& T_cur_ref, const TwoViewData& data) {
  std::vector<bool> front(data.size());
  for (int i = 0; i < data.size(); ++i) {
    const TwoRayPoint p = triangulate(T_cur_ref, data.x_ref[i], data.x_cur[i]);
    front[i] = p.in_front || std::abs(p.inv_depth) < 3 * p.sigma * data.sigma;
  }
  return front;
}

SE3 refineEpipolar(const SE3& T_cur_ref, const TwoViewData& data, int iterations) {
  SE3 T(T_cur_ref.quaternion(), T_cur_ref.translation().normalized());
  double cost = cauchyCost(T, data), lambda = 1e-4;
  for (int k = 0; k < iterations; ++k) {
    Mat5 H;
    Vec5 b;
    normalEquations(T, data, H, b);
    H.diagonal() *= 1 + lambda;
    H.diagonal().array() += 1e-12;
    const Vec5 step = H.ldlt().solve(b);
    if (!step.allFinite()) break;
    const Vec3 t = T.translation() + sphereTangent(T.translation()) * step.tail<2>();
    const SE3 next(so3Exp(step.head<3>()) * T.quaternion(), t.normalized());
    const double next_cost = cauchyCost(next, data);
    if (next_cost < cost) {
      const bool done = next_cost > cost * (1 - 1e-6);
      T = next;
      cost = next_cost;
      lambda = std::max(1e-7, lambda * 0.1);
      if (done) break;
    } else {
      lambda = std::max(1e-3, lambda * 10);
      if (lambda > 1e4) break;
    }
  }
  return T;
}

SE3 fitEssential(const TwoViewData& data, const std::vector<SE3>& starts) {
  const auto minimal = [&](const std::vector<int>& sample) { return fivePoint(data, sample); };
  const auto polish = [&](const SE3& T, int rounds) { return refineEpipolar(T, data, 3 * rounds); };
  // A correspondence behind a camera is as bad as an outlier.
  const auto cost = [&](const SE3& T) {
    std::vector<double> errors = epipolarErrors(T, data);
    const std::vector<bool> front = inFront(T, data);
    for (int i = 0; i < data.size(); ++i)
      if (!front[i]) errors[i] = data.inlier;
    return truncatedCost(errors, data.inlier);
  };
  return randomSearch<SE3>(data, 5, starts, minimal, polish, cost);
}

}  // namespace svoscope
