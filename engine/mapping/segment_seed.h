// SPDX-License-Identifier: MIT
// Segments of the map and their seeds: plain data. A segment has two end points, each a bearing of
// the keyframe that detected it; other views constrain them across the line only.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/kinds.h"
#include "engine/base/types.h"
#include "engine/detect/segment_detector.h"
#include "engine/mapping/depth_filter.h"
#include "engine/mapping/seed_life.h"

namespace svoscope {

struct SegmentParameters {
  bool enabled = false;  ///< set by the method
  SegmentDetectorParameters detector;
  // Alignment in the image
  int level = 0;                  ///< pyramid level of reference patches
  int max_samples = 6;            ///< 1-D alignments per segment
  double sample_spacing_px = 14;  ///< between them, px of the search level
  double max_shift_px = 8;        ///< alignment farther from the prediction is refused, level px
  double fit_inlier_px = 1.0;     ///< distance of a sample from the fitted line, level px
  // Seeds
  int search_samples = 5;        ///< epipolar searches per seed and frame
  double min_edge_cosine = 0.4;  ///< between segment normal and epipolar line; below: no depth
  int max_job_seeds = 100;       ///< measured per frame
  double promote_sigma = 0.05;   ///< a tracked seed becomes a landmark at this relative sigma
  // Tracking
  int max_tracked = 40;          ///< per frame
  int max_tries = 70;            ///< alignments of segments per frame
  double max_prediction_px = 4;  ///< a seed whose depth leaves more doubt across its line waits
  int patches_per_segment = 3;   ///< for sparse image alignment, at most
  int max_patches = 60;          ///< of all segments, for sparse image alignment
  // Pose
  double line_noise_px = 0.5;  ///< across the line, at an end of the measured piece
  double max_depth_px =
      0.3;  ///< a depth that leaves more doubt across the line does not enter the pose
  double pose_sigma = 2;    ///< noise of a segment relative to a corner
  double min_scale = 0.3;   ///< floor of the robust scale, relative to line_noise_px
  double max_error_px = 2;  ///< an end point farther from its line makes an outlier
  int max_failures = 10;    ///< a segment that failed more often, and often, is deleted
};

/// What one view saw: end points on the measured line, level-0 px, with unit bearings.
struct SegmentAnchor {
  Vec2 px[2] = {Vec2::Zero(), Vec2::Zero()};
  Vec3 f[2] = {Vec3::UnitZ(), Vec3::UnitZ()};
  int level = 0;
};

/// One belief per end point; a and b are shared and equal in both.
struct SegmentSeed : SeedLife {
  SegmentAnchor anchor;
  Belief belief[2];
  double last_x[2] = {0, 0}, last_tau[2] = {0, 0};
};

struct SegmentMeasurement {
  std::int64_t seed_id = -1;
  int keyframe_id = -1;
  int frame_index = -1;
  SearchOutcome outcome = SearchOutcome::none;
  double x[2] = {0, 0}, tau[2] = {0, 0};  ///< inverse distances along the bearings, and sigmas
};

struct SegmentView {
  int keyframe_id = -1;
  SegmentAnchor anchor;  ///< the line; its ends are where it was visible
};

struct SegmentLandmark {
  std::int64_t id = -1;
  Vec3 p_world[2] = {Vec3::Zero(), Vec3::Zero()};
  Mat3 covariance[2] = {Mat3::Zero(), Mat3::Zero()};  ///< of the end points across the line, world
  std::vector<SegmentView> views;                     ///< first: where it was detected
  /// What the seed knew when promoted: inverse distance in the first view and its sigma.
  double prior[2] = {0, 0}, prior_sigma[2] = {0, 0};
  int succeeded = 0, failed = 0;  ///< frames that tried it: inlier of the pose or not
};

/// The segments' part of a mapping job and of its result.
struct JobSegmentSeed {
  std::int64_t id = -1;
  int keyframe_slot = 0;
  SegmentAnchor anchor;
  double mu[2] = {1, 1}, sigma[2] = {1, 1};
};
struct SegmentJob {
  std::vector<JobSegmentSeed> seeds;
  std::vector<DetectedSegment> tracked;  ///< where the new keyframe already has segments
};
struct NewSegmentSeed {
  SegmentAnchor anchor;
  std::vector<SegmentMeasurement> measurements;
};
struct SegmentJobResult {
  std::vector<SegmentMeasurement> measurements;
  std::vector<NewSegmentSeed> new_seeds;
};

}  // namespace svoscope
