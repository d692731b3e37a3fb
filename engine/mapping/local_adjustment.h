// SPDX-License-Identifier: MIT
// Local bundle adjustment: poses, landmarks and segments of the keyframes around the newest one,
// jointly, with robust reprojection errors (Ceres, Schur complement). Pure: values in, values out.
#pragma once

#include <vector>

#include "engine/mapping/map.h"

namespace svoscope {

struct LocalAdjustmentParameters {
  bool enabled = true;
  int keyframes = 8;        ///< optimised besides the newest, those that share most landmarks
  int fixed_keyframes = 8;  ///< held, others that see the same landmarks
  int max_iterations = 8;
  double robust_px = 0.7;    ///< scale of the Huber loss, px, times 2^level
  double edgelet_sigma = 2;  ///< noise of an edgelet relative to a corner
  double outlier_px = 3;     ///< observations above are removed, px, times 2^level
  int segment_views = 3;     ///< of a segment in the window: two views of a line cannot contradict
  /// Least sigma of a segment seed's depth over the depth. The seed's measurements share the errors
  /// of the poses they were made with; believed as they stand, they hold the map to a wrong scale.
  double depth_floor = 0.1;
  double max_time_ms = 80;  ///< time box; not in synchronous runs, which must repeat
};

struct AdjustmentKeyframe {
  int id = -1;
  SE3 T_cam_world;
  bool fixed = false;
};

struct AdjustmentPoint {
  std::int64_t id = -1;
  Vec3 p_world = Vec3::Zero();
};

struct AdjustmentObservation {
  int keyframe = 0, point = 0;  ///< indices
  Vec2 px = Vec2::Zero();       ///< level 0
  int level = 0;
  FeatureType type = FeatureType::corner;
  Vec2 gradient_dir = Vec2::Zero();
};

/// An end point of a segment. Where it lies along the line is held near where it was (`along`).
struct AdjustmentEnd {
  std::int64_t segment_id = -1;
  int end = 0;
  Vec3 p_world = Vec3::Zero();
};

/// direction . (projection - px) / sigma: the distance of an end point from a measured line, or its
/// place along it.
struct AdjustmentLineView {
  int keyframe = 0, end = 0;  ///< indices
  Vec2 px = Vec2::Zero();     ///< level 0
  Vec2 direction = Vec2::Zero();
  double sigma = 1;  ///< px
  bool along = false;
};

/// What the seed knew of an end point: inverse distance along the bearing `f` of its keyframe.
struct AdjustmentDepth {
  int keyframe = 0, end = 0;  ///< indices
  Vec3 f = Vec3::UnitZ();
  double inv_distance = 1, sigma = 1;
};

struct AdjustmentProblem {
  Pinhole camera;
  std::vector<AdjustmentKeyframe> keyframes;  ///< by id
  std::vector<AdjustmentPoint> points;
  std::vector<AdjustmentObservation> observations;
  std::vector<AdjustmentEnd> ends;
  std::vector<AdjustmentLineView> line_views;
  std::vector<AdjustmentDepth> depths;
  bool timed = false;  ///< apply max_time_ms
  int newest = -1;     ///< id of the keyframe it was built around

  bool empty() const { return observations.empty(); }
};

struct AdjustmentResult {
  bool ok = false;
  int newest = -1;                            ///< of the problem; -1: there was none
  std::vector<AdjustmentKeyframe> keyframes;  ///< as in the problem, poses refined
  std::vector<AdjustmentPoint> points;
  std::vector<AdjustmentEnd> ends;
  struct Outlier {
    std::int64_t landmark_id = -1;
    int keyframe_id = -1;
  };
  std::vector<Outlier> outliers;
  std::vector<Outlier> segment_outliers;  ///< views whose line is far from an end point
  double initial_px = 0, final_px = 0;    ///< RMS of the robust residuals
  int iterations = 0;
  double time_ms = 0;
};

/// Window around keyframe `newest`: it, the keyframes sharing most landmarks with it, their
/// landmarks and segments with two views at least, and held keyframes that see those too.
AdjustmentProblem localProblem(const Map& map, int newest,
                               const LocalAdjustmentParameters& parameters,
                               const SegmentParameters& segments);

AdjustmentResult adjustLocally(const AdjustmentProblem& problem,
                               const LocalAdjustmentParameters& parameters);

}  // namespace svoscope
