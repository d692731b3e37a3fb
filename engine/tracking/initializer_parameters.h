// SPDX-License-Identifier: MIT
#pragma once

#include "engine/base/result.h"
#include "engine/tracking/klt.h"

namespace svoscope {

struct InitializerParameters {
  int max_tracks = 300;            ///< grid cells of a reference frame; count
  int min_tracks = 25;             ///< a reference with fewer live tracks is given up; count
  int min_inliers = 20;            ///< points of the first map; count
  double min_track_ratio = 0.3;    ///< live tracks relative to those at the start of a reference
  double renew_track_ratio = 0.7;  ///< below this a further reference is started
  double min_inlier_ratio = 0.4;   ///< of the live tracks
  int max_references = 3;          ///< alive at the same time; count
  int max_age = 600;               ///< frames after which a reference is given up; count
  double min_disparity_px = 0;     ///< median track length before two views are tried, px;
                                   ///< 0: 1.5 % of the image width
  double min_parallax_px = 2.0;    ///< what the best rotation must leave of it, median, px
  double max_rms_px = 1.25;        ///< of the joint refinement; px
  double max_depth_sigma = 0.05;   ///< median relative uncertainty of depth; ratio
  double noise_px = 0.15;          ///< least assumed error of a track, px
  double model_error = 0.002;      ///< error of the camera model (rolling shutter, focal length)
                                   ///< relative to the image motion by rotation; ratio
  int min_frames = 2;              ///< frames after the reference: a third view tests the first two
  int max_samples = 100;           ///< of each random search over two views; count
  int refine_frames = 6;           ///< frames refined jointly, the current one included; count
  KltParameters klt;

  /// Ok, or which parameter is out of range.
  Status check() const;
};

}  // namespace svoscope
