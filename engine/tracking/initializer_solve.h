// SPDX-License-Identifier: MIT
// From the tracks of one reference frame to poses and points, or the reason why not.
#pragma once

#include <string>
#include <vector>

#include "engine/geometry/camera.h"
#include "engine/geometry/two_view.h"
#include "engine/tracking/initializer_parameters.h"
#include "engine/tracking/initializer_reference.h"

namespace svoscope {

struct StartPoint {
  int track = -1;        ///< index into the reference's tracks
  double inv_depth = 0;  ///< 1 / z in the reference; median of z is 1
  double sigma_inv_depth = 0;
  double residual_px = 0;
};

struct StartSolution {
  TwoViewVerdict verdict = TwoViewVerdict::too_few_tracks;
  TwoViewModel model = TwoViewModel::none;
  std::string reason;
  std::vector<StartPoint> points;
  std::vector<SE3> T_frame_ref;  ///< one per frame of the reference; the last is the current
  double rms_px = 0, parallax_deg = 0, depth_sigma = 0;
  double scale_px = 0;  ///< robust standard deviation of the residuals, px
  double rotation_residual_px = 0;
  SE3 T_cur_ref;  ///< of the joint refinement, also if not accepted; |t| = 1
                  ///< unless accepted; identity if it was not reached
};

/// Two views (reference and last frame), then joint robust refinement over some frames between.
StartSolution solveStart(const InitializerReference& reference, const Pinhole& camera,
                         const InitializerParameters& parameters);

}  // namespace svoscope
