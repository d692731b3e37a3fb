// SPDX-License-Identifier: MIT
// The depth filter alone on a sequence with true depth: seeds are detected in keyframes, searched
// for in the frames after with given camera poses, and every rule's seeds are held against the
// truth (docs/filters.md). Each rule leads its own searches, as it would in the odometry.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/dataset/sequence.h"
#include "engine/mapping/seed_update.h"
#include "engine/snapshot/frame_record.h"
#include "engine/study/gate_sweep.h"

namespace svoscope {

struct DepthStudyOptions {
  MappingParameters mapping;
  int start = 0, max_frames = -1;  ///< -1: to the end
  int keyframe_every = 15;         ///< frames between keyframes
  int max_age = 60;                ///< frames in which a seed is searched for
  int seeds_per_keyframe = 200;
  double right_error = 0.05;  ///< relative depth error up to which a seed is right
  double max_spread = 0.05;   ///< depths of the 5x5 px around a seed may differ by this share
  /// T_world_cam in metres by frame of the sequence; frames without are passed over.
  std::vector<std::optional<SE3>> poses;
  std::string poses_from;  ///< "groundtruth" or "estimate", for the record
  /// Called after every frame; false ends the study early.
  std::function<bool(int done, int total)> progress;
};

struct DepthStudyRow {
  std::string rule;  ///< name of its RuleVariant
  int seeds = 0;
  int converged = 0, rejected = 0,
      unfinished = 0;                    ///< converged: sigma below the threshold, any ratio
  int accepted = 0, accepted_wrong = 0;  ///< converged with an inlier ratio above the gate
  double recall = 0;                     ///< accepted and right / seeds
  std::optional<double> median_updates;  ///< to converge, of the converged
  std::vector<std::optional<double>> error_quantiles;  ///< relative depth error of the accepted
  std::optional<double> wrong_at_80, wrong_at_60, wrong_at_40;  ///< wrong fraction at that recall
  std::optional<double> median_nees;     ///< (error / sigma)^2 of the accepted; calibrated: 0.455
  std::optional<double> nees_inside_95;  ///< share of the accepted below 3.84; calibrated: 0.95
  int measurements = 0, failures = 0;    ///< searches with and without a match
  std::optional<double> outlier_share;   ///< measurements off by more than 3 tau and 5 %
  std::optional<double>
      median_measurement_nees;            ///< (error / tau)^2 of measurements; calibrated: 0.455
  std::vector<double> errors;             ///< sorted, of the accepted
  std::vector<double> normalised_errors;  ///< |error| / sigma, sorted, of the accepted
  std::vector<double> converged_by_age;   ///< share of seeds, by frames since the keyframe
  std::vector<GatePoint> sweep;
};

/// Of DepthStudyRow::error_quantiles.
constexpr double kErrorQuantiles[] = {0.1, 0.25, 0.5, 0.75, 0.9, 0.95};

struct DepthStudyResult {
  std::string sequence, poses_from;
  int frames = 0, keyframes = 0;
  int edge_seeds = 0;  ///< left out: the truth is ambiguous at a depth edge, or unknown
  std::vector<DepthStudyRow> rows;  ///< in the order of ruleVariants()
};

/// Input error if the sequence lacks ground truth or depth.
Status depthStudyPossible(Sequence& sequence);

/// Input error if the sequence has no depth or no frame has a pose.
Result<DepthStudyResult> runDepthStudy(Sequence& sequence, const DepthStudyOptions& options);

/// Ground-truth pose of every frame, interpolated in time; none where the truth has a gap of more
/// than `max_gap` seconds around the frame.
std::vector<std::optional<SE3>> groundTruthPoses(const Sequence& sequence, double max_gap = 0.1);

/// Estimated poses moved and scaled onto the ground truth. Input error if that is not determined.
Result<std::vector<std::optional<SE3>>> alignedPoses(const Sequence& sequence,
                                                     const std::vector<FrameRecord>& records);

}  // namespace svoscope
