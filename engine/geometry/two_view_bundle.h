// SPDX-License-Identifier: MIT
// Joint refinement of camera poses and point depths over a few frames that all saw the points of
// one reference frame. Every point is an inverse depth on the exact ray of its reference
// position, as in direct methods: patches are cut out there and looked for elsewhere.
#pragma once

#include <limits>
#include <vector>

#include "engine/geometry/se3.h"

namespace svoscope {

/// Position that was not measured.
inline Vec2 notMeasured() { return Vec2::Constant(std::numeric_limits<double>::quiet_NaN()); }

/// Points of a reference frame and the frames that track them. Lengths are in units of |t| of
/// the last frame, which is held at 1 (the scale cannot be seen).
struct MultiViewProblem {
  std::vector<Vec2> x_ref;           ///< per point, unit plane of the reference
  std::vector<Vec2> normal_ref;      ///< per point: zero for a corner; for an edgelet the unit
                                     ///< gradient direction: only the error along it counts
  std::vector<double> inv_depth;     ///< per point, 1 / z in the reference; refined
  std::vector<SE3> T_frame_ref;      ///< per frame; refined
  std::vector<std::vector<Vec2>> x;  ///< [frame][point], unit plane; notMeasured() where lost
};

struct MultiViewOptions {
  double focal = 500;  ///< px
  int max_iterations = 15;
  double min_scale_px = 0.3;     ///< least scale of the robust (Cauchy) loss
  double edgelet_weight = 0.25;  ///< relative information of an edgelet (frontend-facts, 4)
  bool poses_only = false;       ///< depths are held; frames become independent
};

struct MultiViewSummary {
  bool converged = false;  ///< false: the equations were singular
  int iterations = 0;
  double scale_px = 0;           ///< robust standard deviation of the residuals (per axis)
  double cost = 0;               ///< mean robust cost per residual axis, px^2-like
  std::vector<double> point_px;  ///< per point: rms over the frames, px; infinite if never seen
  std::vector<double> sigma_inv_depth;  ///< per point, relative to the common scale: standard
                                        ///< deviation for residuals of 1 px, 1 / unit
  double sigma_direction = 0;           ///< of the last frame's translation, radians, for 1 px
};

/// Levenberg-Marquardt, depths eliminated (Schur complement), Cauchy loss with a scale estimated
/// from the residuals.
MultiViewSummary refineMultiView(MultiViewProblem& problem, const MultiViewOptions& options);

/// Residual of one point in one frame, px, and its derivatives; for tests and the solver.
struct MultiViewResidual {
  Vec2 r = Vec2::Zero();         ///< measured - predicted
  Mat26 J_pose = Mat26::Zero();  ///< by a left perturbation exp(xi) T_frame_ref
  Vec2 J_inv_depth = Vec2::Zero();
  bool valid = false;  ///< measured and in front of the camera
};
MultiViewResidual multiViewResidual(const SE3& T_frame_ref, const Vec2& x_ref, double inv_depth,
                                    const Vec2& x, double focal);

}  // namespace svoscope
