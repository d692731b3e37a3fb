// SPDX-License-Identifier: MIT
// Projects landmarks and seeds of the nearby keyframes into the current frame and aligns one per
// grid cell, best first.
#pragma once

#include <vector>

#include "engine/mapping/seed_update.h"
#include "engine/tracking/frame.h"

namespace svoscope {

struct ReprojectorParameters {
  int cell_px = 30;                ///< grid cell, px at 640 px width
  int max_features = 180;          ///< matches after which the frame is full
  int local_keyframes = 8;         ///< nearest overlapping keyframes searched
  double max_view_angle_deg = 66;  ///< between the landmark's reference view and the current one
  double max_shift_px = 16;  ///< alignment ending farther from the prediction is refused, level px
  int max_failures =
      10;  ///< a landmark that failed more often, and in a fifth of its frames, is deleted
  bool unconverged_seeds = true;  ///< track seeds before they converge
  int max_tries = 500;            ///< alignments per frame
  int coarser = 0;  ///< levels added to the search level: each doubles the capture range
};

/// Measurement of a seed made while tracking; applied by the tracker once the pose is final.
struct TrackedSeedMatch {
  int feature = -1;  ///< index into the frame's features; -1: search failed
  std::int64_t seed_id = -1;
  int keyframe_id = -1;
  SearchOutcome outcome = SearchOutcome::none;
  double score = 0;  ///< of the epipolar search; 0: no scan
};

struct ReprojectionResult {
  std::vector<TrackedFeature> features;  ///< aligned
  std::vector<TrackedFeature> failed;    ///< projected and tried without success
  std::vector<TrackedSeedMatch> seed_matches;
  std::vector<int> local_keyframes;  ///< ids, nearest first
  OccupancyGrid occupied;            ///< cells holding a match
  int candidates = 0, projected = 0, tried = 0;
};

/// `frame` brings pyramid and predicted pose.
ReprojectionResult reprojectMap(const Map& map, const Frame& frame,
                                const ReprojectorParameters& parameters,
                                const MappingParameters& mapping);

/// Ids of the keyframes that share the view of `frame`, nearest first, at most `most`.
std::vector<int> overlappingKeyframes(const Map& map, const SE3& T_cam_world, int most);

/// Inverse distance if the measurement x +/- tau is right: the product of both Gaussians, without
/// the filter's doubt.
double fusedInverseDistance(const Belief& belief, double x, double tau);

/// Point of a seed in the world, at its current mean.
Vec3 seedPoint(const Seed& seed, const Keyframe& keyframe);

}  // namespace svoscope
