// SPDX-License-Identifier: MIT
// The equations behind two_view_bundle.h.
#pragma once

#include "engine/geometry/two_view_bundle.h"

namespace svoscope {

/// One measurement as the solver sees it: two rows for a corner, one for an edgelet.
struct WeightedResidual {
  Vec2 r = Vec2::Zero();
  Mat26 J_pose = Mat26::Zero();
  Vec2 J_inv_depth = Vec2::Zero();
  double information = 1;  ///< prior weight
  int rows = 2;
  bool valid = false;
};
WeightedResidual weightedResidual(const MultiViewProblem& problem, std::size_t frame,
                                  std::size_t point, double focal, double edgelet_weight);

/// Cauchy cost with scale c (px), summed over all measurements and divided by their rows.
double bundleCost(const MultiViewProblem& problem, const MultiViewOptions& options, double c);

struct BundleStep {
  Eigen::VectorXd poses;      ///< six per frame, left perturbation
  Eigen::VectorXd inv_depth;  ///< one per point
  bool valid = false;
};
BundleStep bundleStep(const MultiViewProblem& problem, const MultiViewOptions& options, double c,
                      double lambda);

/// Fills sigma_inv_depth and sigma_direction for residuals of 1 px.
void bundleCovariance(const MultiViewProblem& problem, const MultiViewOptions& options, double c,
                      MultiViewSummary& summary);

}  // namespace svoscope
