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

using PoseBlock = std::array<double, 6>;  // rotation vector, translation of T_cam_world
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

/// Reprojection error, in units of its noise.
struct PixelError {
  const Pinhole& camera;
  Vec2 px;
  double weight;
  template <typename T>
  bool operator()(const T* pose, const T* point, T* e) const {
    T projected[2];
    if (!projectPoint(camera, pose, point, projected)) return false;
    e[0] = T(weight) * (projected[0] - T(px.x()));
    e[1] = T(weight) * (projected[1] - T(px.y()));
    return true;
  }
};

/// The same along one direction: the gradient of an edgelet, the normal of a line.
struct DirectedError {
  const Pinhole& camera;
  Vec2 px, direction;
  double weight;
  template <typename T>
  bool operator()(const T* pose, const T* point, T* e) const {
    T projected[2];
    if (!projectPoint(camera, pose, point, projected)) return false;
    e[0] = T(weight) * (T(direction.x()) * (projected[0] - T(px.x())) +
                        T(direction.y()) * (projected[1] - T(px.y())));
    return true;
  }
};

/// Error of the inverse distance along a bearing, in sigmas. `scale` is common to all of them: they
/// carry no independent scale information, as they were measured in the map and share its scale's
/// error.
struct InverseDistanceError {
  Vec3 f;
  double inv_distance, sigma;
  template <typename T>
  bool operator()(const T* pose, const T* point, const T* scale, T* e) const {
    T p[3];
    ceres::AngleAxisRotatePoint(pose, point, p);
    const T distance =
        T(f.x()) * (p[0] + pose[3]) + T(f.y()) * (p[1] + pose[4]) + T(f.z()) * (p[2] + pose[5]);
    if (distance < T(1e-4)) return false;
    e[0] = (scale[0] / distance - T(inv_distance)) / T(sigma);
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
    for (const AdjustmentPoint& x : problem.points)
      points_.push_back({x.p_world.x(), x.p_world.y(), x.p_world.z()});
    for (const AdjustmentEnd& x : problem.ends)
      points_.push_back({x.p_world.x(), x.p_world.y(), x.p_world.z()});
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
      if (ceres_problem.HasParameterBlock(x.data()))
        options.linear_solver_ordering->AddElementToGroup(x.data(), 1);
    }
    if (!problem_.depths.empty())
      options.linear_solver_ordering->AddElementToGroup(&depth_scale_, 1);
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
  double* pose(int keyframe) { return poses_[static_cast<std::size_t>(keyframe)].data(); }
  PointBlock& point(int index) { return points_[static_cast<std::size_t>(index)]; }
  std::size_t endBlock(int index) const {
    return problem_.points.size() + static_cast<std::size_t>(index);
  }
  double* end(int index) { return points_[endBlock(index)].data(); }

  void build(ceres::Problem& ceres_problem) {
    const Pinhole& camera = problem_.camera;
    for (const AdjustmentObservation& o : problem_.observations) {
      const double weight = 1.0 / (1 << o.level);
      ceres::CostFunction* cost = nullptr;
      if (o.type == FeatureType::edgelet) {
        cost = new ceres::AutoDiffCostFunction<DirectedError, 1, 6, 3>(
            new DirectedError{camera, o.px, o.gradient_dir, weight / p_.edgelet_sigma});
      } else {
        cost = new ceres::AutoDiffCostFunction<PixelError, 2, 6, 3>(
            new PixelError{camera, o.px, weight});
      }
      ceres_problem.AddResidualBlock(cost, &robust_, pose(o.keyframe), point(o.point).data());
    }
    for (const AdjustmentLineView& v : problem_.line_views) {
      auto* cost = new ceres::AutoDiffCostFunction<DirectedError, 1, 6, 3>(
          new DirectedError{camera, v.px, v.direction, 1 / v.sigma});
      ceres_problem.AddResidualBlock(cost, v.along ? nullptr : &robust_, pose(v.keyframe),
                                     end(v.end));
    }
    for (const AdjustmentDepth& d : problem_.depths) {
      auto* cost = new ceres::AutoDiffCostFunction<InverseDistanceError, 1, 6, 3, 1>(
          new InverseDistanceError{d.f, d.inv_distance, d.sigma});
      ceres_problem.AddResidualBlock(cost, &robust_, pose(d.keyframe), end(d.end), &depth_scale_);
    }
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      if (problem_.keyframes[i].fixed && ceres_problem.HasParameterBlock(poses_[i].data()))
        ceres_problem.SetParameterBlockConstant(poses_[i].data());
    }
  }

  void collect(AdjustmentResult& result) const {
    result.keyframes = problem_.keyframes;
    result.points = problem_.points;
    result.ends = problem_.ends;
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      if (!result.keyframes[i].fixed) result.keyframes[i].T_cam_world = fromBlock(poses_[i]);
    }
    const std::size_t points = problem_.points.size();
    for (std::size_t i = 0; i < points; ++i) result.points[i].p_world = Vec3(points_[i].data());
    for (std::size_t i = 0; i < problem_.ends.size(); ++i)
      result.ends[i].p_world = Vec3(points_[points + i].data());
    collectOutliers(result);
  }

  /// Projected minus measured; false behind the camera.
  bool errorAt(int keyframe, const PointBlock& point, const Vec2& px, Vec2& e) const {
    double projected[2];
    if (!projectPoint(problem_.camera, poses_[static_cast<std::size_t>(keyframe)].data(),
                      point.data(), projected))
      return false;
    e = Vec2(projected[0], projected[1]) - px;
    return true;
  }

  void collectOutliers(AdjustmentResult& result) const {
    Vec2 e;
    for (const AdjustmentObservation& o : problem_.observations) {
      const auto x = static_cast<std::size_t>(o.point);
      const bool front = errorAt(o.keyframe, points_[x], o.px, e);
      if (o.type == FeatureType::edgelet) e = Vec2(o.gradient_dir.dot(e), 0);
      if (!front || e.norm() > p_.outlier_px * (1 << o.level))
        result.outliers.push_back({problem_.points[x].id, keyframeId(o.keyframe)});
    }
    for (const AdjustmentLineView& v : problem_.line_views) {
      const bool front = errorAt(v.keyframe, points_[endBlock(v.end)], v.px, e);
      if (!v.along && (!front || std::abs(v.direction.dot(e)) > p_.outlier_px * v.sigma))
        result.segment_outliers.push_back(
            {problem_.ends[static_cast<std::size_t>(v.end)].segment_id, keyframeId(v.keyframe)});
    }
  }
  int keyframeId(int keyframe) const {
    return problem_.keyframes[static_cast<std::size_t>(keyframe)].id;
  }

  const AdjustmentProblem& problem_;
  const LocalAdjustmentParameters& p_;
  ceres::HuberLoss robust_;
  std::vector<PoseBlock> poses_;
  /// Landmarks, then end points: in one piece, as Ceres orders blocks by their address.
  std::vector<PointBlock> points_;
  double depth_scale_ = 1;
};

}  // namespace

AdjustmentResult adjustLocally(const AdjustmentProblem& problem,
                               const LocalAdjustmentParameters& p) {
  AdjustmentResult result;
  if (!problem.empty() && problem.points.size() >= 10) result = Adjustment(problem, p).run();
  result.newest = problem.newest;
  return result;
}

}  // namespace svoscope
