// SPDX-License-Identifier: MIT
// The fields of a frame's record: one list for recordings, frames.csv, plots, the values of scripts
// and the table of docs/commands.md. A new field is a member of FrameRecord and a line here.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "engine/snapshot/frame_record.h"

namespace svoscope {

struct FrameField {
  const char* name;     ///< of its column; the pose has none, but seven columns
  const char* unit;     ///< "" if it has none
  const char* meaning;  ///< for the documentation
  bool applies = true;  ///< to this record; where not, plots have a gap
  int decimals = -1;    ///< of a real number in frames.csv; -1: nine significant digits
};

/// Columns of a pose: camera to world, unit quaternion last.
constexpr const char* kPoseColumns[] = {"tx", "ty", "tz", "qx", "qy", "qz", "qw"};

/// Column of a stage's time, "ms_pose".
const char* stageColumn(Stage stage);
const char* stageMeaning(Stage stage);

template <typename R, typename F>
void visitFunnelFields(R& funnel, F&& f) {
  f(FrameField{"aligned_sparse", "", "patches used by sparse image alignment"},
    funnel.aligned_sparse);
  f(FrameField{"candidates", "", "landmarks and seeds of the local map"}, funnel.candidates);
  f(FrameField{"projected", "", "of these, inside the image"}, funnel.projected);
  f(FrameField{"tried", "", "feature alignments attempted"}, funnel.tried);
  f(FrameField{"matched", "", "feature alignments that converged"}, funnel.matched);
  f(FrameField{"inliers", "", "left after pose refinement"}, funnel.inliers);
  f(FrameField{"inlier_landmarks", "", "of the inliers, landmarks"}, funnel.inlier_landmarks);
  f(FrameField{"inlier_seeds", "", "of the inliers, seeds, converged or not"}, funnel.inlier_seeds);
  f(FrameField{"inlier_edgelets", "", "of the inliers, edgelets"}, funnel.inlier_edgelets);
  f(FrameField{"inlier_segments", "", "of the inliers, segments"}, funnel.inlier_segments);
  f(FrameField{"followed_segments", "",
               "of the matched: segments kept out of the pose, as their depth is in doubt"},
    funnel.followed_segments);
  f(FrameField{"required", "", "fewer inliers than this: lost"}, funnel.required);
}

/// Calls f(FrameField, member of the record) for every field, in the order of the columns. Members
/// are bool, int, double, std::string, TrackingState or SE3.
template <typename R, typename F>
void visitFrameFields(R& r, F&& f) {
  const bool good = r.pose_good;
  f(FrameField{"index", "", "frame in the sequence, from 0"}, r.index);
  f(FrameField{"timestamp", "s", "of the image", true, 6}, r.timestamp);
  f(FrameField{"state", "", "`initializing`, `tracking` or `lost`"}, r.state);
  f(FrameField{"pose_good", "", "the frame has a pose"}, r.pose_good);
  f(FrameField{"map", "",
               "the map whose world it is given in, from 0; `trajectory.txt` has those of one map"},
    r.map_id);
  f(FrameField{"is_keyframe", "", "the frame became a keyframe"}, r.is_keyframe);
  f(FrameField{"keyframe_id", "", "which keyframe it became; -1: none"}, r.keyframe_id);
  f(FrameField{"relocalized", "", "first good pose after a loss"}, r.relocalized);
  f(FrameField{"reason", "", "why the frame is in this state"}, r.reason);
  f(FrameField{"keyframe_reason", "", "why a keyframe was taken or not"}, r.keyframe_reason);
  f(FrameField{"", "map", "camera to world; empty without a good pose", good}, r.T_world_cam);
  visitFunnelFields(r.funnel, f);
  f(FrameField{"align_rmse", "grey", "residual of sparse alignment", good}, r.align_rmse);
  f(FrameField{"reprojection_px", "px", "median reprojection error of the inliers, at level 0",
               good},
    r.reprojection_px);
  const bool aligned = r.funnel.aligned_sparse > 0;
  f(FrameField{"gain", "", "brightness relative to the previous frame, factor", aligned}, r.gain);
  f(FrameField{"offset", "grey", "brightness relative to the previous frame, summand", aligned},
    r.offset);
  f(FrameField{"median_depth", "map", "of the tracked features", good}, r.median_depth);
  f(FrameField{"disparity_tracks", "", "two-view start: tracks alive"}, r.disparity_tracks);
  f(FrameField{"disparity_px", "px", "two-view start: their median disparity",
               r.disparity_tracks > 0},
    r.disparity_px);
  f(FrameField{"landmarks", "", "in the map after the frame"}, r.landmarks);
  f(FrameField{"seeds", "", "in the map after the frame"}, r.seeds);
  f(FrameField{"keyframes", "", "in the map after the frame"}, r.keyframes);
  f(FrameField{"seeds_converged", "", "seeds that converged during the frame"}, r.seeds_converged);
  f(FrameField{"seeds_rejected", "", "seeds that were rejected during the frame"},
    r.seeds_rejected);
  f(FrameField{"seed_updates", "", "measurements of point seeds during the frame"}, r.seed_updates);
  f(FrameField{"segment_updates", "", "measurements of segment seeds during the frame"},
    r.segment_updates);
  for (int i = 0; i < kStageCount; ++i) {
    const auto stage = static_cast<Stage>(i);
    f(FrameField{stageColumn(stage), "ms", stageMeaning(stage), true, 4},
      r.time_ms[static_cast<std::size_t>(i)]);
  }
}

/// Every field as a number, in the order of the list: flags are 0 or 1; texts, poses and what does
/// not apply to the record are NaN.
std::vector<double> frameNumbers(const FrameRecord& record);
/// Place in frameNumbers().
std::optional<std::size_t> frameFieldIndex(std::string_view name);

}  // namespace svoscope
