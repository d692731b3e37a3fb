// SPDX-License-Identifier: MIT
#pragma once

#include "engine/tracking/klt.h"

namespace svoscope {

/// Meanings and bounds: engine/runner/parameter_table.h, `start.*`.
struct InitializerParameters {
  int max_tracks = 300;
  int min_tracks = 25;
  int min_inliers = 20;
  double min_track_ratio = 0.3;
  double renew_track_ratio = 0.7;
  double min_inlier_ratio = 0.4;
  int max_references = 3;
  int max_age = 600;            ///< frames
  double min_disparity_px = 0;  ///< 0: 1.5 % of the image width
  double min_parallax_px = 2.0;
  double max_rms_px = 1.25;
  double max_depth_sigma = 0.05;  ///< relative
  double noise_px = 0.15;
  double model_error = 0.002;  ///< relative to the image motion by rotation
  int min_frames = 2;
  int max_samples = 100;
  int refine_frames = 6;
  KltParameters klt;
};

}  // namespace svoscope
