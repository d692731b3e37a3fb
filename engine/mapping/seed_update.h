// SPDX-License-Identifier: MIT
// Measuring seeds: the mapping job searches a frame for seeds of older keyframes and returns
// measurements; the owner of the map applies them. So no state is shared between threads and the
// order of application alone decides the result.
#pragma once

#include <vector>

#include "engine/detect/feature_detector.h"
#include "engine/mapping/local_adjustment.h"
#include "engine/mapping/map.h"
#include "engine/match/epipolar_search.h"
#include "engine/snapshot/snapshot.h"

namespace svoscope {

struct DepthFilterParameters {
  double initial_sigma_fraction = 1.0 / 6;  ///< sigma = R * this
  double initial_ab = 10;                   ///< Beta parameters a = b at the start
  double converged_fraction = 1.0 / 200;    ///< converged when sigma < R * this ...
  double min_inlier_ratio = 0.5;            ///< ... and a / (a + b) above this
  double reject_inlier_ratio = 0.08;        ///< rejected below
  int max_seeds_per_keyframe = 400;
  FilterRule rule = FilterRule::kl;  ///< decided by the method
  RuleSettings rules;
  bool shadow = true;  ///< update the other rules too, where they can be seen
};

/// Values the mapping thread needs of one keyframe.
struct JobKeyframe {
  int id = -1;
  PyramidPtr pyramid;
  SE3 T_cam_world;
  int frame_index = -1;
  double scale = 1;  ///< Keyframe::scale when the job was made
};

/// The scale in which the measurements of a keyframe's seeds are given.
struct JobScale {
  int keyframe_id = -1;
  double scale = 1;
};

struct JobSeed {
  std::int64_t id = -1;
  int keyframe_slot = 0;  ///< index into MappingJob::keyframes
  FeatureAnchor anchor;
  double mu = 1, sigma = 1;  ///< inverse distance
};

/// Wish for new seeds in the frame of the job, which became a keyframe.
struct NewSeedRequest {
  bool wanted = false;
  int keyframe_id = -1;
  OccupancyGrid occupied;
  double median_depth = 1, min_depth = 0.5;
  double scale = 1;  ///< Keyframe::scale when the job was made
};

struct MappingJob {
  int frame_index = -1;
  PyramidPtr pyramid;
  SE3 T_cam_world;
  Pinhole camera;
  double noise_px = 0;  ///< of the frame's features; a match is at least that uncertain
  std::vector<JobKeyframe> keyframes;
  std::vector<JobSeed> seeds;
  NewSeedRequest new_seeds;
  SegmentJob segments;
  /// Older views that new seeds are measured against at once.
  std::vector<JobKeyframe> older_views;
  AdjustmentProblem adjustment;  ///< of the keyframe's neighbourhood; may be empty
};

struct SeedMeasurement {
  std::int64_t seed_id = -1;
  int keyframe_id = -1;  ///< that owns the seed
  int frame_index = -1;  ///< that was searched
  SearchOutcome outcome = SearchOutcome::none;
  double x = 0, tau = 0;
  Vec2 px = Vec2::Zero();  ///< match, level 0
  double score = 0;        ///< of the best sample; 0: no scan
};

struct NewSeed {
  DetectedFeature feature;
  std::vector<SeedMeasurement> measurements;  ///< from the older views
};

struct MappingResult {
  int frame_index = -1;
  int keyframe_id = -1;  ///< of the new seeds
  std::vector<SeedMeasurement> measurements;
  std::vector<NewSeed> new_seeds;
  SegmentJobResult segments;
  double median_depth = 1, min_depth = 0.5;
  std::vector<JobScale> scales;  ///< of the keyframes that own the seeds measured and found
  AdjustmentResult adjustment;
  double time_ms = 0;
};

struct MappingParameters {
  DetectorParameters detector;
  EpipolarParameters search;
  FeatureAlignmentParameters alignment;
  DepthFilterParameters filter;
  SegmentParameters segments;
  LocalAdjustmentParameters local_ba;
};

/// Runs a job. Pure: reads only the job.
MappingResult runMappingJob(const MappingJob& job, const MappingParameters& parameters);

/// A fresh seed: mu = 1 / median distance, R = 1 / (0.5 nearest distance).
Seed makeSeed(const DetectedFeature& feature, const Pinhole& camera, double median_depth,
              double min_depth, const DepthFilterParameters& parameters);

/// Applies a measurement (or its absence) to the beliefs of all rules, and by the one in use to
/// the status of a seed.
void applyMeasurement(Seed& seed, const SeedMeasurement& m,
                      const DepthFilterParameters& parameters);

/// The belief of one rule, for display; sigma = 0 if it was not computed.
BeliefView beliefView(const Seed& seed, FilterRule rule, FilterRule rule_in_use);

/// What measurement `m` did to a seed, for display.
SeedUpdateView describeUpdate(const Seed& before, const Seed& after, const SeedMeasurement& m,
                              FilterRule rule_in_use);

}  // namespace svoscope
