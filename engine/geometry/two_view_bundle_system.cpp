// SPDX-License-Identifier: MIT
#include "engine/geometry/two_view_bundle_system.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "engine/geometry/triangulation.h"

namespace svoscope {

namespace {

using Eigen::Index;

/// Normal equations with one scalar per point: H = [A C; C^T D], A block diagonal, D diagonal.
struct NormalEquations {
  Eigen::MatrixXd A;     ///< 6K x 6K
  Eigen::MatrixXd C;     ///< 6K x N
  Eigen::VectorXd D;     ///< N
  Eigen::VectorXd a, d;  ///< right-hand sides
};

NormalEquations assemble(const MultiViewProblem& p, const MultiViewOptions& o, double c) {
  const Index frames = static_cast<Index>(p.T_frame_ref.size());
  const Index points = static_cast<Index>(p.x_ref.size());
  NormalEquations n;
  n.A = Eigen::MatrixXd::Zero(6 * frames, 6 * frames);
  n.C = Eigen::MatrixXd::Zero(6 * frames, points);
  n.D = Eigen::VectorXd::Zero(points);
  n.a = Eigen::VectorXd::Zero(6 * frames);
  n.d = Eigen::VectorXd::Zero(points);
  for (Index k = 0; k < frames; ++k) {
    Mat6 A = Mat6::Zero();
    Vec6 a = Vec6::Zero();
    for (Index i = 0; i < points; ++i) {
      const WeightedResidual r = weightedResidual(
          p, static_cast<std::size_t>(k), static_cast<std::size_t>(i), o.focal, o.edgelet_weight);
      if (!r.valid) continue;
      const double w = r.information / (1 + r.r.squaredNorm() / (c * c));
      A.noalias() += w * r.J_pose.transpose() * r.J_pose;
      a.noalias() -= w * r.J_pose.transpose() * r.r;
      n.C.block<6, 1>(6 * k, i).noalias() = w * r.J_pose.transpose() * r.J_inv_depth;
      n.D[i] += w * r.J_inv_depth.squaredNorm();
      n.d[i] -= w * r.J_inv_depth.dot(r.r);
    }
    n.A.block<6, 6>(6 * k, 6 * k) = A;
    n.a.segment<6>(6 * k) = a;
  }
  return n;
}

/// In a fixed order: the last digits of Eigen's mean() depend on the address of the values. 1 if
/// empty.
double meanOf(const Eigen::VectorXd& v) {
  double sum = 0;
  for (const double x : v) sum += x;
  return v.size() > 0 ? sum / static_cast<double>(v.size()) : 1;
}

/// Makes the unobservable scale stiff: the last translation keeps its length.
void holdScale(const MultiViewProblem& p, Eigen::MatrixXd& A) {
  const Index at = A.rows() - 6;
  const Vec3 u = p.T_frame_ref.back().translation().normalized();
  const double stiff = A.diagonal().maxCoeff();
  A.block<3, 3>(at, at) += stiff * u * u.transpose();
}

}  // namespace

MultiViewResidual multiViewResidual(const SE3& T_frame_ref, const Vec2& x_ref, double inv_depth,
                                    const Vec2& x, double focal) {
  // The point times its inverse depth: finite at infinity, and the projection is the same.
  MultiViewResidual out;
  const Vec3 q =
      T_frame_ref.quaternion() * x_ref.homogeneous() + inv_depth * T_frame_ref.translation();
  out.valid = x.allFinite() && q.z() > 1e-3;
  if (!out.valid) return out;
  const Mat23 P = focal * unitPlaneJacobian(q);
  out.r = focal * (x - q.hnormalized());
  out.J_pose.leftCols<3>() = -inv_depth * P;
  out.J_pose.rightCols<3>() = P * hat(q);
  out.J_inv_depth = -P * T_frame_ref.translation();
  return out;
}

WeightedResidual weightedResidual(const MultiViewProblem& problem, std::size_t frame,
                                  std::size_t point, double focal, double edgelet_weight) {
  const SE3& T = problem.T_frame_ref[frame];
  const MultiViewResidual full = multiViewResidual(
      T, problem.x_ref[point], problem.inv_depth[point], problem.x[frame][point], focal);
  WeightedResidual out;
  out.valid = full.valid;
  if (!out.valid) return out;
  out.r = full.r;
  out.J_pose = full.J_pose;
  out.J_inv_depth = full.J_inv_depth;
  const Vec2& n = problem.normal_ref[point];
  if (n.squaredNorm() == 0) return out;
  // The edge turns with the camera: carry its tangent over by the rotation, then take the normal.
  const Vec3 along(-n.y(), n.x(), 0);
  const Vec3 q = T.quaternion() * problem.x_ref[point].homogeneous();
  const Vec2 tangent = (unitPlaneJacobian(q) * (T.quaternion() * along)).normalized();
  const Vec2 normal(tangent.y(), -tangent.x());
  out.rows = 1;
  out.information = edgelet_weight;
  out.r = Vec2(normal.dot(full.r), 0);
  out.J_pose.row(0) = normal.transpose() * full.J_pose;
  out.J_pose.row(1).setZero();
  out.J_inv_depth = Vec2(normal.dot(full.J_inv_depth), 0);
  return out;
}

double bundleCost(const MultiViewProblem& problem, const MultiViewOptions& options, double c) {
  double sum = 0, rows = 0;
  for (std::size_t k = 0; k < problem.T_frame_ref.size(); ++k)
    for (std::size_t i = 0; i < problem.x_ref.size(); ++i) {
      if (!problem.x[k][i].allFinite()) continue;
      const WeightedResidual r =
          weightedResidual(problem, k, i, options.focal, options.edgelet_weight);
      // A point that falls behind the camera pays as if it were 20 scales off.
      const double e2 = r.valid ? r.r.squaredNorm() : 400 * c * c;
      sum += r.information * c * c * std::log1p(e2 / (c * c));
      rows += r.rows;
    }
  return rows > 0 ? sum / rows : 0;
}

BundleStep bundleStep(const MultiViewProblem& problem, const MultiViewOptions& options, double c,
                      double lambda) {
  NormalEquations n = assemble(problem, options, c);
  BundleStep step;
  n.A.diagonal() *= 1 + lambda;
  n.A.diagonal().array() += 1e-9;
  step.inv_depth = Eigen::VectorXd::Zero(n.D.size());
  if (options.poses_only) {
    step.poses = n.A.ldlt().solve(n.a);
    step.valid = step.poses.allFinite();
    return step;
  }
  holdScale(problem, n.A);
  const double floor = 1e-6 * meanOf(n.D) + 1e-12;
  const Eigen::VectorXd D = n.D * (1 + lambda) + Eigen::VectorXd::Constant(n.D.size(), floor);
  const Eigen::MatrixXd CD = n.C * D.cwiseInverse().asDiagonal();
  const Eigen::MatrixXd S = n.A - CD * n.C.transpose();
  step.poses = S.ldlt().solve(n.a - CD * n.d);
  step.inv_depth = (n.d - n.C.transpose() * step.poses).cwiseQuotient(D);
  step.valid = step.poses.allFinite() && step.inv_depth.allFinite();
  return step;
}

void bundleCovariance(const MultiViewProblem& problem, const MultiViewOptions& options, double c,
                      MultiViewSummary& summary) {
  NormalEquations n = assemble(problem, options, c);
  const Index points = n.D.size(), last = n.A.rows() - 6;
  holdScale(problem, n.A);
  const double floor = 1e-6 * meanOf(n.D) + 1e-12;
  const Eigen::VectorXd D = n.D.array() + floor;
  const Eigen::MatrixXd CD = n.C * D.cwiseInverse().asDiagonal();
  Eigen::MatrixXd S = n.A - CD * n.C.transpose();
  S.diagonal().array() += 1e-9 * n.A.diagonal().maxCoeff();
  const Eigen::LLT<Eigen::MatrixXd> llt(S);
  summary.sigma_inv_depth.assign(static_cast<std::size_t>(points),
                                 std::numeric_limits<double>::infinity());
  if (llt.info() != Eigen::Success) return;
  // Cov(depths) = 1/D + CD^T S^-1 CD. An error common to all, relative to depth, is only a change
  // of the free scale: project it out before reading off the diagonal.
  Eigen::MatrixXd M = llt.matrixL().solve(CD);  // 6K x N
  const Eigen::Map<const Eigen::VectorXd> rho(problem.inv_depth.data(), points);
  // Well determined points count most, so that one wild point does not pass for the scale.
  const Eigen::VectorXd information = D.cwiseProduct(rho);
  const Eigen::VectorXd common = M * information / std::max(information.dot(rho), 1e-12);
  M -= common * rho.transpose();
  for (Index i = 0; i < points; ++i)
    summary.sigma_inv_depth[static_cast<std::size_t>(i)] =
        std::sqrt(1 / D[i] + M.col(i).squaredNorm());
  Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(n.A.rows(), 3);
  unit.block<3, 3>(last, 0).setIdentity();
  const Mat3 cov = llt.matrixL().solve(unit).transpose() * llt.matrixL().solve(unit);
  const Vec3 u = problem.T_frame_ref.back().translation().normalized();
  summary.sigma_direction = std::sqrt(std::max(0.0, cov.trace() - u.dot(cov * u)));
}

}  // namespace svoscope
