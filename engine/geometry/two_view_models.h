// SPDX-License-Identifier: MIT
// Robust single models for two_view.h: rotation, homography and relative pose. All positions are
// on the unit plane; errors are one distance per correspondence, in units of that plane.
#pragma once

#include <vector>

#include "engine/geometry/se3.h"

namespace svoscope {

/// Correspondences and the scale of their errors.
struct TwoViewData {
  const std::vector<Vec2>& x_ref;
  const std::vector<Vec2>& x_cur;
  double sigma = 0;   ///< noise, unit plane
  double inlier = 0;  ///< inlier limit, unit plane
  int max_samples = 200;
  unsigned seed = 1;
  int size() const { return static_cast<int>(x_ref.size()); }
};

/// Sum of min(e^2, limit^2) / limit^2 (MSAC, Torr and Zisserman 2000): between 0 and the count.
double truncatedCost(const std::vector<double>& errors, double limit);

Eigen::Quaterniond fitRotation(const TwoViewData& data);
std::vector<double> rotationErrors(const Eigen::Quaterniond& q_cur_ref, const TwoViewData& data);

/// x_cur ~ H x_ref, scaled so that the middle singular value is 1 and det H > 0.
Mat3 fitHomography(const TwoViewData& data);
std::vector<double> homographyErrors(const Mat3& H_cur_ref, const TwoViewData& data);

/// Sampson distances from the epipolar geometry of the pose.
std::vector<double> epipolarErrors(const SE3& T_cur_ref, const TwoViewData& data);
/// Minimises the robust (Cauchy) Sampson error over rotation and direction of translation.
SE3 refineEpipolar(const SE3& T_cur_ref, const TwoViewData& data, int iterations);
/// Random search with five points and local optimisation; |t| = 1. The sign of t and the choice
/// among rotations follow from the points' being in front.
SE3 fitEssential(const TwoViewData& data, const std::vector<SE3>& starts);

/// Correspondences not clearly behind a camera: far points scatter around infinity, so a negative
/// inverse depth counts against the pose only beyond three sigma.
std::vector<bool> inFront(const SE3& T_cur_ref, const TwoViewData& data);

}  // namespace svoscope
