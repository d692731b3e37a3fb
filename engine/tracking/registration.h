// SPDX-License-Identifier: MIT
// Registering a frame on the map from a prediction of its pose. Pure: frame, map and everything
// else stay as they are, and what was found, good or refused, is the value returned.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/snapshot/frame_record.h"
#include "engine/tracking/frame.h"
#include "engine/tracking/tracker_parameters.h"

namespace svoscope {

using StageTimes = std::array<double, kStageCount>;  ///< ms

/// Where the frame may be, relative to the last one.
struct Prediction {
  SE3 T_cur_last;
  bool wide = false;  ///< by registering the images as wholes, with a wider search
};

/// What was found from one prediction.
struct Registration {
  bool judged = false;  ///< was held against the thresholds; else nothing below but the failure
  std::string failure;  ///< why it was refused; empty if it was accepted
  SE3 T_cam_world;
  double noise_px = 0;                                    ///< robust scale of the features' errors
  std::vector<TrackedFeature> features, failed_features;  ///< aligned; tried without success
  std::vector<TrackedSegment> segments, failed_segments;
  std::vector<TrackedSeedMatch> seed_matches;
  std::vector<int> local_keyframes;  ///< ids, nearest first
  OccupancyGrid occupied;            ///< cells holding a match
  SparseAlignmentResult aligned;
  Funnel funnel;  ///< up to the inliers and the number required
  StageTimes time_ms{};

  bool good() const { return judged && failure.empty(); }
};

/// Registers `frame`, which brings its pyramid, by the features of `last` and the map: sparse image
/// alignment, reprojection, pose.
Registration registerFrame(const Frame& frame, const Frame& last, const Map& map,
                           const Prediction& prediction, const TrackerParameters& parameters);

/// Registers `frame` after a loss, near a pose that a keyframe suggests. At a wrong pose chance
/// alone matches some of hundreds of features: a share of what was tried must fit, and it must fit
/// about as well as usual (`usual_noise_px`; 0: not known). If it does not, the result is not
/// judged any further.
Registration relocalizeFrame(const Frame& frame, const Map& map, const SE3& T_cam_world,
                             double usual_noise_px, const TrackerParameters& parameters);

/// Inlier features and segments of a frame as patches for aligning the next one to it.
std::vector<AlignmentPatch> alignmentPatches(const Frame& frame, const Pinhole& camera,
                                             const SegmentParameters& segments);

/// Adds the times of one part of a frame's work to those of the whole.
void addTimes(const StageTimes& times, StageTimes& sum);

}  // namespace svoscope
