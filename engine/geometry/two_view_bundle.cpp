// SPDX-License-Identifier: MIT
#include "engine/geometry/two_view_bundle.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "engine/base/quantile.h"
#include "engine/geometry/triangulation.h"
#include "engine/geometry/two_view_bundle_system.h"

namespace svoscope {

namespace {

/// 1.48 x median of the residual lengths per axis: the standard deviation if Gaussian.
double residualScale(const MultiViewProblem& p, double focal) {
  std::vector<double> values;
  for (std::size_t k = 0; k < p.T_frame_ref.size(); ++k)
    for (std::size_t i = 0; i < p.x_ref.size(); ++i) {
      const WeightedResidual r = weightedResidual(p, k, i, focal, 1.0);
      if (!r.valid) continue;
      for (int a = 0; a < r.rows; ++a) values.push_back(std::abs(r.r[a]));
    }
  return 1.4826 * upperMedian(std::move(values));
}

/// The scale is free: hold |t| of the last frame at 1.
void normalizeScale(MultiViewProblem& p) {
  const double length = p.T_frame_ref.back().translation().norm();
  if (!(length > 0)) return;
  for (SE3& T : p.T_frame_ref) T = SE3(T.quaternion(), T.translation() / length);
  for (double& d : p.inv_depth) d *= length;
}

MultiViewProblem stepped(const MultiViewProblem& p, const BundleStep& step) {
  MultiViewProblem next = p;
  for (std::size_t k = 0; k < p.T_frame_ref.size(); ++k) {
    const Vec6 xi = step.poses.segment<6>(static_cast<Eigen::Index>(6 * k));
    next.T_frame_ref[k] = SE3(so3Exp(xi.tail<3>()) * p.T_frame_ref[k].quaternion(),
                              so3Exp(xi.tail<3>()) * p.T_frame_ref[k].translation() + xi.head<3>());
  }
  for (std::size_t i = 0; i < p.inv_depth.size(); ++i)
    next.inv_depth[i] += step.inv_depth[static_cast<Eigen::Index>(i)];
  return next;
}

void fillPointErrors(const MultiViewProblem& p, const MultiViewOptions& o, MultiViewSummary& s) {
  s.point_px.assign(p.x_ref.size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < p.x_ref.size(); ++i) {
    double sum = 0;
    int rows = 0;
    for (std::size_t k = 0; k < p.T_frame_ref.size(); ++k) {
      const WeightedResidual r = weightedResidual(p, k, i, o.focal, 1.0);
      if (!r.valid) continue;
      sum += r.r.squaredNorm();
      rows += r.rows;
    }
    if (rows > 0) s.point_px[i] = std::sqrt(sum / rows);
  }
}

}  // namespace

MultiViewSummary refineMultiView(MultiViewProblem& problem, const MultiViewOptions& options) {
  MultiViewSummary out;
  if (problem.T_frame_ref.empty() || problem.x_ref.empty()) return out;
  const double scale = residualScale(problem, options.focal);
  double c = std::max(options.min_scale_px, 1.5 * scale);
  double cost = bundleCost(problem, options, c), lambda = 1e-4;
  bool rescaled = false;
  out.converged = true;
  for (; out.iterations < options.max_iterations; ++out.iterations) {
    // The first residuals are those of a rough start: estimate their scale again half way.
    if (out.iterations >= 5 && !rescaled) {
      c = std::max(options.min_scale_px, 1.5 * residualScale(problem, options.focal));
      cost = bundleCost(problem, options, c);
      rescaled = true;
    }
    const BundleStep step = bundleStep(problem, options, c, lambda);
    if (!step.valid) {
      out.converged = false;
      break;
    }
    const MultiViewProblem next = stepped(problem, step);
    const double next_cost = bundleCost(next, options, c);
    if (next_cost < cost) {
      const bool done = next_cost > cost * (1 - 1e-4);
      problem = next;
      if (!options.poses_only) normalizeScale(problem);
      cost = next_cost;
      lambda = std::max(1e-8, lambda * 0.2);
      if (done && rescaled) break;
    } else {
      lambda *= 10;
      if (lambda > 1e3) break;
    }
  }
  out.scale_px = residualScale(problem, options.focal);
  out.cost = cost;
  fillPointErrors(problem, options, out);
  if (!options.poses_only) bundleCovariance(problem, options, c, out);
  return out;
}

}  // namespace svoscope
