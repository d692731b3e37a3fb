// SPDX-License-Identifier: MIT
// The small, fixed-size part of a frame's result: one row of frames.csv and one sample of every
// plot. Kept for all frames of a run, while full snapshots may be evicted.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "engine/geometry/se3.h"

namespace svoscope {

enum class TrackingState : std::uint8_t { initializing, tracking, lost };

/// Stages that are timed, in the order in which a frame passes them.
enum class Stage : std::uint8_t {
  read,     ///< decode the image (not part of tracking)
  rectify,  ///< remove lens distortion (not part of tracking)
  pyramid,
  initialize,  ///< two-view start; zero once tracking
  sparse_align,
  reproject,  ///< candidates, projection, feature alignment
  pose,       ///< pose refinement
  structure,  ///< landmark refinement
  keyframe,   ///< decision and bookkeeping
  relocalize,
  tracking,  ///< all of the above but read and rectify: the tracking thread's time
  mapping,   ///< mapping job of this frame (own thread unless synchronous)
  snapshot,  ///< building and publishing the snapshot
  count_
};
constexpr int kStageCount = static_cast<int>(Stage::count_);
const char* stageName(Stage stage);

/// Features surviving each step of a frame, and the thresholds they are held against.
struct Funnel {
  int aligned_sparse = 0;  ///< patches used by sparse image alignment
  int candidates = 0;      ///< landmarks and seeds of the local map
  int projected = 0;       ///< of these, inside the image
  int tried = 0;           ///< feature alignments attempted
  int matched = 0;         ///< feature alignments that converged
  int inliers = 0;         ///< left after pose refinement
  int inlier_landmarks = 0;
  int inlier_seeds = 0;     ///< converged and unconverged
  int inlier_edgelets = 0;  ///< of the inliers, edgelets
  int inlier_segments = 0;
  int followed_segments =
      0;             ///< of the matched, kept out of the pose: measured for their depth only
  int required = 0;  ///< inliers below this: lost
};

struct FrameRecord {
  int index = -1;        ///< frame in the sequence
  double timestamp = 0;  ///< s
  TrackingState state = TrackingState::initializing;
  bool pose_good = false;  ///< the pose goes into the trajectory
  bool is_keyframe = false;
  int keyframe_id = -1;         ///< if is_keyframe
  std::string reason;           ///< why in this state: "tracking", "31 inliers < 40 required", ...
  std::string keyframe_reason;  ///< why a keyframe was, or was not, taken
  SE3 T_world_cam;              ///< map scale; meaningful if pose_good
  int map_id = 0;  ///< whose world that is; grows when a map is given up for a new start
  Funnel funnel;
  double align_rmse = 0;                        ///< sparse alignment, grey levels
  double reprojection_px = 0;                   ///< median of inliers, px at level 0
  double gain = 1, offset = 0;                  ///< brightness relative to the previous frame
  double median_depth = 0;                      ///< of tracked features, map scale
  int disparity_tracks = 0;                     ///< two-view start: tracks alive
  double disparity_px = 0;                      ///< two-view start: median disparity
  int landmarks = 0, seeds = 0, keyframes = 0;  ///< in the map after this frame
  int seeds_converged = 0, seeds_rejected = 0;  ///< during this frame
  int seed_updates = 0;                         ///< measurements of point seeds during this frame
  int segment_updates = 0;                      ///< measurements of segment seeds during this frame
  bool relocalized = false;                     ///< first good pose after a loss
  std::array<double, kStageCount> time_ms{};

  double ms(Stage s) const { return time_ms[static_cast<int>(s)]; }
};

const char* stateName(TrackingState state);

}  // namespace svoscope
