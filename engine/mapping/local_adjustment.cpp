// SPDX-License-Identifier: MIT
#include "engine/mapping/local_adjustment.h"

#include <ceres/autodiff_cost_function.h>
#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/rotation.h>
#include <ceres/solver.h>

#include <array>
#include <cmath>

#include "engine/base/stopwatch.h"

namespace svoscope {

namespace {

using PoseBlock = std::array<double, 6>;   // rotation vector, translation of T_cam_world
using PointBlock = std::array<double, 3>;

template <typename T>
bool projectPoint(const Pinhole& camera, const T* pose, const T* point, T* px) {
  T p[3];
  ceres::AngleAxisRotatePoint(pose, point, p);
  p[0] += pose[3];
  p[1] += pose[4];
  p[2] += pose[5];
  if (p[2] < T(1e-4)) return false;
  px[0] = T(camera.fx) * p[0] / p[2] + T(camera.cx);
  px[1] = T(camera.fy) * p[1] / p[2] + T(camera.cy);
  return true;
}

/// Reprojection error of a corner, in units of its noise.
struct CornerError {
  const Pinhole& camera;
  const AdjustmentObservation& o;
  double weight;
  template <typename T>
  bool operator()(const T* pose, const T* point, T* e) const {
    T px[2];
    if (!projectPoint(camera, pose, point, px)) return false;
    e[0] = T(weight) * (px[0] - T(o.px.x()));
    e[1] = T(weight) * (px[1] - T(o.px.y()));
    return true;
  }
};

/// Error of an edgelet along its gradient, in units of its noise.
struct EdgeletError {
  const Pinhole& camera;
  const AdjustmentObservation& o;
  double weight;
  template <typename T>
  bool operator()(const T* pose, const T* point, T* e) const {
    T px[2];
    if (!projectPoint(camera, pose, point, px)) return false;
    e[0] = T(weight) * (T(o.gradient_dir.x()) * (px[0] - T(o.px.x())) + T(o.gradient_dir.y()) * (px[1] - T(o.px.y())));
    return true;
  }
};

PoseBlock toBlock(const SE3& T) {
  const Vec3 w = so3Log(T.quaternion()), t = T.translation();
  return {w.x(), w.y(), w.z(), t.x(), t.y(), t.z()};
}

SE3 fromBlock(const PoseBlock& b) {
  return SE3(so3Exp(Vec3(b[0], b[1], b[2])), Vec3(b[3], b[4], b[5]));
}

class Adjustment {
 public:
  Adjustment(const AdjustmentProblem& problem, const LocalAdjustmentParameters& p)
      : problem_(problem), p_(p), robust_(p.robust_px) {
    for (const AdjustmentKeyframe& k : problem.keyframes) poses_.push_back(toBlock(k.T_cam_world));
    for (const AdjustmentPoint& x : problem.points) points_.push_back({x.p_world.x(), x.p_world.y(), x.p_world.z()});
  }

  AdjustmentResult run() {
    Stopwatch watch;
    AdjustmentResult result;
    ceres::Problem::Options ownership;
    ownership.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ceres::Problem ceres_problem(ownership);
    build(ceres_problem);
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_SCHUR;
    options.max_num_iterations = p_.max_iterations;
    options.function_tolerance = 1e-4;
    options.num_threads = 1;
    options.logging_type = ceres::SILENT;
    if (problem_.timed) options.max_solver_time_in_seconds = 1e-3 * p_.max_time_ms;
    options.linear_solver_ordering = std::make_shared<ceres::ParameterBlockOrdering>();
    for (PointBlock& x : points_) options.linear_solver_ordering->AddElementToGroup(x.data(), 0);
    for (PoseBlock& x : poses_) {
      if (ceres_problem.HasParameterBlock(x.data())) options.linear_solver_ordering->AddElementToGroup(x.data(), 1);
    }
    ceres::Solver::Summary summary;
    ceres::Solve(options, &ceres_problem, &summary);
    result.ok = summary.IsSolutionUsable();
    const double count = std::max<double>(1, static_cast<double>(problem_.observations.size()));
    result.initial_px = std::sqrt(2 * summary.initial_cost / count);
    result.final_px = std::sqrt(2 * summary.final_cost / count);
    result.iterations = static_cast<int>(summary.iterations.size());
    if (result.ok) collect(result);
    result.time_ms = watch.ms();
    return result;
  }

 private:
  void build(ceres::Problem& ceres_problem) {
    for (const AdjustmentObservation& o : problem_.observations) {
      double* pose = poses_[static_cast<std::size_t>(o.keyframe)].data();
      double* point = points_[static_cast<std::size_t>(o.point)].data();
      const double weight = 1.0 / (1 << o.level);
      ceres::CostFunction* cost = nullptr;
      if (o.type == FeatureType::edgelet) {
        cost = new ceres::AutoDiffCostFunction<EdgeletError, 1, 6, 3>(
            new EdgeletError{problem_.camera, o, weight / p_.edgelet_sigma});
      } else {
        cost = new ceres::AutoDiffCostFunction<CornerError, 2, 6, 3>(new CornerError{problem_.camera, o, weight});
      }
      ceres_problem.AddResidualBlock(cost, &robust_, pose, point);
    }
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      if (problem_.keyframes[i].fixed && ceres_problem.HasParameterBlock(poses_[i].data()))
        ceres_problem.SetParameterBlockConstant(poses_[i].data());
    }
  }

  void collect(AdjustmentResult& result) const {
    result.keyframes = problem_.keyframes;
    result.points = problem_.points;
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      if (!result.keyframes[i].fixed) result.keyframes[i].T_cam_world = fromBlock(poses_[i]);
    }
    for (std::size_t i = 0; i < points_.size(); ++i)
      result.points[i].p_world = Vec3(points_[i][0], points_[i][1], points_[i][2]);
    for (const AdjustmentObservation& o : problem_.observations) {
      const auto k = static_cast<std::size_t>(o.keyframe), x = static_cast<std::size_t>(o.point);
      double px[2] = {1e9, 1e9};
      const bool front = projectPoint(problem_.camera, poses_[k].data(), points_[x].data(), px);
      Vec2 e = o.px - Vec2(px[0], px[1]);
      if (o.type == FeatureType::edgelet) e = Vec2(o.gradient_dir.dot(e), 0);
      if (!front || e.norm() > p_.outlier_px * (1 << o.level))
        result.outliers.push_back({problem_.points[x].id, problem_.keyframes[k].id});
    }
  }

  const AdjustmentProblem& problem_;
  const LocalAdjustmentParameters& p_;
  ceres::HuberLoss robust_;
  std::vector<PoseBlock> poses_;
  std::vector<PointBlock> points_;
};

}  // namespace

AdjustmentResult adjustLocally(const AdjustmentProblem& problem, const LocalAdjustmentParameters& p) {
  if (problem.empty() || problem.points.size() < 10) return {};
  return Adjustment(problem, p).run();
}

}  // namespace svoscope
