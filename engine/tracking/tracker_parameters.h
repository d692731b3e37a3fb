// SPDX-License-Identifier: MIT
// Parameters of everything the tracker is made of.
#pragma once

#include "engine/mapping/seed_update.h"
#include "engine/tracking/initializer_parameters.h"
#include "engine/tracking/keyframe_policy.h"
#include "engine/tracking/pose_refinement.h"
#include "engine/tracking/relocalizer.h"
#include "engine/tracking/reprojector.h"
#include "engine/tracking/sparse_alignment.h"

namespace svoscope {

struct QualityParameters {
  int min_inliers = 20;              ///< fewer after pose refinement: lost
  double min_inlier_fraction = 0.4;  ///< of the matched features; below: lost
  double min_tried_fraction =
      0.12;                      ///< of the features tried; below, a few edgelets may fit by chance
  int relocalized_inliers = 30;  ///< needed to accept a relocalisation ...
  double relocalized_fraction = 0.2;  ///< ... and this share of the features tried
  double relocalized_noise = 4;       ///< ... and errors at most so many times the usual ones
  int fresh_lost_frames = 10;  ///< lost for this long with a fresh map: look for another start, too
  int lost_frames = 60;        ///< the same with any other map
  int fresh_map_keyframes = 3;   ///< a map with at most this many keyframes is fresh
  int structure_iterations = 5;  ///< Gauss-Newton steps per landmark and frame
};

struct TrackerParameters {
  InitializerParameters start;
  SparseAlignmentParameters alignment;
  ReprojectorParameters reproject;
  PoseRefinementParameters pose;
  KeyframeParameters keyframe;
  QualityParameters quality;
  RelocalizerParameters relocalize;
  MappingParameters mapping;
};

}  // namespace svoscope
