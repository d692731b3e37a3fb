// SPDX-License-Identifier: MIT
// The table behind parameters.h: key, field, unit, meaning, bounds.
#pragma once

#include "engine/runner/parameters.h"

namespace svoscope {

struct ParameterInfo {
  const char* key;
  const char* unit;
  const char* meaning;
  double minimum, maximum;
  bool needs_reset = false;
};

/// A key without a group stands at the top level of a configuration file.
/// Calls f(info, field) for every parameter; fields are int, double or bool references.
template <typename P, typename F>
void visitTracking(P& p, F&& f) {
  auto& t = p.tracker;
  f(ParameterInfo{"align.max_level", "level", "coarsest pyramid level of sparse alignment", 0, 7},
    t.alignment.max_level);
  f(ParameterInfo{"align.min_level", "level", "finest pyramid level of sparse alignment", 0, 7},
    t.alignment.min_level);
  f(ParameterInfo{"align.max_iterations", "", "Gauss-Newton steps per level", 1, 100},
    t.alignment.max_iterations);
  f(ParameterInfo{"align.min_step_px", "px", "sparse alignment converged below, level px", 0.0001,
                  1},
    t.alignment.min_step_px);
  f(ParameterInfo{"align.estimate_gain", "", "estimate brightness gain and offset of the frame", 0,
                  1},
    t.alignment.estimate_gain);
  f(ParameterInfo{"align.max_patches", "", "patches used at most", 10, 2000},
    t.alignment.max_patches);
  f(ParameterInfo{"reproject.cell_px", "px", "grid cell at 640 px width", 8, 200},
    t.reproject.cell_px);
  f(ParameterInfo{"reproject.max_features", "", "matches after which a frame is full", 20, 2000},
    t.reproject.max_features);
  f(ParameterInfo{"reproject.local_keyframes", "", "nearest overlapping keyframes searched", 1, 50},
    t.reproject.local_keyframes);
  f(ParameterInfo{"reproject.max_view_angle_deg", "deg",
                  "between reference and current view of a landmark", 5, 89},
    t.reproject.max_view_angle_deg);
  f(ParameterInfo{"reproject.max_shift_px", "px",
                  "alignment may move from the prediction, search level", 1, 100},
    t.reproject.max_shift_px);
  f(ParameterInfo{"reproject.max_failures", "",
                  "frames without it as an inlier before a landmark is deleted", 1, 1000},
    t.reproject.max_failures);
  f(ParameterInfo{"reproject.unconverged_seeds", "", "track seeds before they converge", 0, 1},
    t.reproject.unconverged_seeds);
  f(ParameterInfo{"reproject.max_tries", "", "alignments per frame at most", 20, 5000},
    t.reproject.max_tries);
  f(ParameterInfo{"pose.max_iterations", "", "Gauss-Newton steps of pose refinement", 1, 100},
    t.pose.max_iterations);
  f(ParameterInfo{"pose.max_error_px", "px", "reprojection error of an inlier, times 2^level", 0.1,
                  50},
    t.pose.max_error_px);
  f(ParameterInfo{"pose.edgelet_sigma", "", "noise of an edgelet relative to a corner", 0.1, 20},
    t.pose.edgelet_sigma);
  f(ParameterInfo{"pose.min_scale_px", "px", "floor of the robust scale, times 2^level", 0.01, 10},
    t.pose.min_scale_px);
  f(ParameterInfo{"keyframe.enough_landmarks", "", "no keyframe above", 10, 2000},
    t.keyframe.enough_landmarks);
  f(ParameterInfo{"keyframe.few_landmarks", "", "keyframe at once below", 0, 2000},
    t.keyframe.few_landmarks);
  f(ParameterInfo{"keyframe.still_px", "px",
                  "no keyframe below this motion, at 640 px width, and the next", 0, 100},
    t.keyframe.still_px);
  f(ParameterInfo{"keyframe.still_distance", "",
                  "no keyframe below this distance over median depth, and the one before", 0, 1},
    t.keyframe.still_distance);
  f(ParameterInfo{"keyframe.min_frames", "", "frames between keyframes", 1, 1000},
    t.keyframe.min_frames);
  f(ParameterInfo{"keyframe.min_displacement_px", "px",
                  "median motion since the last keyframe, at 640 px width", 0, 500},
    t.keyframe.min_displacement_px);
  f(ParameterInfo{"keyframe.min_angle_deg", "deg", "rotation to the nearest keyframe", 0, 180},
    t.keyframe.min_angle_deg);
  f(ParameterInfo{"keyframe.min_distance", "", "distance to the nearest keyframe over median depth",
                  0, 10},
    t.keyframe.min_distance);
  f(ParameterInfo{"keyframe.max_keyframes", "", "kept in the map", 2, 100000},
    t.keyframe.max_keyframes);
}

template <typename P, typename F>
void visitMapping(P& p, F&& f) {
  auto& t = p.tracker;
  auto& m = t.mapping;
  f(ParameterInfo{"detect.cell_px", "px", "grid cell for new features, at 640 px width", 8, 200},
    m.detector.cell_px);
  f(ParameterInfo{"detect.fast_threshold", "grey", "FAST corner threshold", 1, 100},
    m.detector.fast_threshold);
  f(ParameterInfo{"detect.corner_levels", "", "pyramid levels searched for corners", 1, 6},
    m.detector.corner_levels);
  f(ParameterInfo{"detect.min_corner_score", "grey/px", "root of the smaller eigenvalue", 0, 100},
    m.detector.min_corner_score);
  f(ParameterInfo{"detect.min_edge_gradient", "grey/px", "edgelet gradient, 0 for none", 0, 100},
    m.detector.min_edge_gradient);
  f(ParameterInfo{"detect.border_px", "px", "kept free on every level", 8, 100},
    m.detector.border_px);
  f(ParameterInfo{"search.sigmas", "", "half width of the epipolar search in standard deviations",
                  0.5, 10},
    m.search.search_sigmas);
  f(ParameterInfo{"search.step_px", "px", "between samples on the epipolar line", 0.1, 4},
    m.search.step_px);
  f(ParameterInfo{"search.max_samples", "", "samples on a long line", 10, 2000},
    m.search.max_samples);
  f(ParameterInfo{"search.short_line_px", "px",
                  "a shorter line is not scanned, the match is aligned from its middle", 0, 20},
    m.search.short_line_px);
  f(ParameterInfo{"search.max_score", "grey^2", "zero-mean SSD per pixel of an accepted match", 1,
                  20000},
    m.search.max_score);
  f(ParameterInfo{"search.min_edge_cosine", "", "between edgelet gradient and epipolar line", 0, 1},
    m.search.min_edge_cosine);
  f(ParameterInfo{"search.min_parallax_deg", "deg", "between the two rays of a match", 0, 10},
    m.search.min_parallax_deg);
  f(ParameterInfo{"search.pixel_noise", "px", "noise of a match along the line", 0.05, 10},
    m.search.pixel_noise);
  f(ParameterInfo{"match.max_iterations", "", "Lucas-Kanade steps of feature alignment", 1, 100},
    m.alignment.max_iterations);
  f(ParameterInfo{"match.min_step_px", "px", "feature alignment converged below", 0.001, 1},
    m.alignment.min_step_px);
  f(ParameterInfo{"match.max_error", "grey", "RMS residual of an accepted alignment", 1, 255},
    m.alignment.max_mean_error);
  f(ParameterInfo{"match.estimate_gain", "", "brightness gain of every patch, besides the offset",
                  0, 1},
    m.alignment.estimate_gain);
  f(ParameterInfo{"filter.initial_ab", "", "Beta parameters of a new seed", 1, 1000},
    m.filter.initial_ab);
  f(ParameterInfo{"filter.initial_sigma", "", "standard deviation of a new seed over its range",
                  0.01, 1},
    m.filter.initial_sigma_fraction);
  f(ParameterInfo{"filter.converged_sigma", "", "converged below this share of the range", 1e-5,
                  0.2},
    m.filter.converged_fraction);
  f(ParameterInfo{"filter.min_inlier_ratio", "", "a/(a+b) of a converged seed", 0, 1},
    m.filter.min_inlier_ratio);
  f(ParameterInfo{"filter.reject_inlier_ratio", "", "a/(a+b) below which a seed is rejected", 0, 1},
    m.filter.reject_inlier_ratio);
  f(ParameterInfo{"filter.shadow", "", "run the rule not in use too, for inspection", 0, 1},
    m.filter.shadow);
  f(ParameterInfo{"filter.js_fuse_variance", "",
                  "JS: variance of the measurement fused with that of the mixture", 0, 1},
    m.filter.rules.js.fuse_variance);
  f(ParameterInfo{"filter.js_weight_responsibility", "",
                  "JS: inlier responsibility weighted by the affinity", 0, 1},
    m.filter.rules.js.weight_responsibility);
  f(ParameterInfo{"filter.max_seeds", "", "new seeds per keyframe", 10, 5000},
    m.filter.max_seeds_per_keyframe);
}

template <typename P, typename F>
void visitAdjustment(P& p, F&& f) {
  auto& b = p.tracker.mapping.local_ba;
  f(ParameterInfo{"local_ba", "", "local bundle adjustment at every keyframe", 0, 1}, b.enabled);
  f(ParameterInfo{"adjust.keyframes", "", "refined besides the newest", 1, 100}, b.keyframes);
  f(ParameterInfo{"adjust.fixed_keyframes", "", "held, others that see the same landmarks", 0, 100},
    b.fixed_keyframes);
  f(ParameterInfo{"adjust.max_iterations", "", "Levenberg-Marquardt steps", 1, 100},
    b.max_iterations);
  f(ParameterInfo{"adjust.robust_px", "px", "scale of the Huber loss, times 2^level", 0.05, 20},
    b.robust_px);
  f(ParameterInfo{"adjust.outlier_px", "px", "views with a larger error are removed, times 2^level",
                  0.1, 50},
    b.outlier_px);
  f(ParameterInfo{"adjust.edgelet_sigma", "", "noise of an edgelet relative to a corner", 0.1, 20},
    b.edgelet_sigma);
  f(ParameterInfo{"adjust.segment_views", "", "of a segment in the window, at least", 2, 20},
    b.segment_views);
  f(ParameterInfo{"adjust.depth_floor", "", "least sigma of a segment seed's depth over the depth",
                  0, 1},
    b.depth_floor);
  f(ParameterInfo{"adjust.max_time_ms", "ms", "time box, not in synchronous runs", 1, 10000},
    b.max_time_ms);
}

template <typename P, typename F>
void visitQuality(P& p, F&& f) {
  auto& t = p.tracker;
  f(ParameterInfo{"quality.min_inliers", "", "fewer after pose refinement: lost", 5, 1000},
    t.quality.min_inliers);
  f(ParameterInfo{"quality.min_inlier_fraction", "", "share of matches that must be inliers", 0, 1},
    t.quality.min_inlier_fraction);
  f(ParameterInfo{"quality.min_tried_fraction", "",
                  "share of the features tried; below, inliers must give twice as many equations",
                  0, 1},
    t.quality.min_tried_fraction);
  f(ParameterInfo{"quality.relocalized_inliers", "", "inliers that confirm a relocalization", 5,
                  1000},
    t.quality.relocalized_inliers);
  f(ParameterInfo{"quality.relocalized_fraction", "",
                  "share of the features tried that confirms a relocalization", 0, 1},
    t.quality.relocalized_fraction);
  f(ParameterInfo{"quality.relocalized_noise", "",
                  "errors over the usual ones that confirm a relocalization", 1, 100},
    t.quality.relocalized_noise);
  f(ParameterInfo{"quality.fresh_lost_frames", "frames",
                  "lost with a young map: look for another start after", 1, 100000},
    t.quality.fresh_lost_frames);
  f(ParameterInfo{"quality.lost_frames", "frames", "the same with any other map", 1, 1000000},
    t.quality.lost_frames);
  f(ParameterInfo{"quality.fresh_map_keyframes", "", "keyframes of a young map at most", 0, 1000},
    t.quality.fresh_map_keyframes);
  f(ParameterInfo{"quality.structure_iterations", "", "Gauss-Newton steps per landmark and frame",
                  0, 50},
    t.quality.structure_iterations);
  f(ParameterInfo{"relocalize.candidates", "", "keyframes tried per frame", 1, 50},
    t.relocalize.candidates);
  f(ParameterInfo{"relocalize.places", "", "keyframes whose landmarks are matched by descriptors",
                  0, 1000},
    t.relocalize.places);
  f(ParameterInfo{"relocalize.min_similarity", "", "correlation of the small images", -1, 1},
    t.relocalize.min_similarity);
  f(ParameterInfo{"relocalize.min_patches", "", "visible after alignment to a keyframe", 5, 1000},
    t.relocalize.min_patches);
}

template <typename P, typename F>
void visitSegments(P& p, F&& f) {
  auto& s = p.tracker.mapping.segments;
  auto& d = s.detector;
  f(ParameterInfo{"segments.detect_level", "level", "pyramid level searched for segments", 0, 3},
    d.level);
  f(ParameterInfo{"segments.min_length_px", "px", "shortest segment, at 640 px width", 15, 500},
    d.min_length_px);
  f(ParameterInfo{"segments.merge_angle_deg", "deg", "between pieces of one line", 0, 20},
    d.merge_angle_deg);
  f(ParameterInfo{"segments.merge_distance_px", "px", "of a piece from the line it continues", 0,
                  10},
    d.merge_distance_px);
  f(ParameterInfo{"segments.merge_gap_px", "px", "between pieces of one line", 0, 200},
    d.merge_gap_px);
  f(ParameterInfo{"segments.separation_px", "px", "between parallel segments", 0, 50},
    d.separation_px);
  f(ParameterInfo{"segments.cell_px", "px", "grid cell for midpoints, at 640 px width", 16, 640},
    d.cell_px);
  f(ParameterInfo{"segments.per_cell", "", "segments with their midpoint in one cell", 1, 100},
    d.per_cell);
  f(ParameterInfo{"segments.max_segments", "", "per keyframe, tracked ones included", 0, 1000},
    d.max_segments);
  f(ParameterInfo{"segments.level", "level", "pyramid level of reference patches", 0, 3}, s.level);
  f(ParameterInfo{"segments.max_samples", "", "1-D alignments along a segment", 3, 50},
    s.max_samples);
  f(ParameterInfo{"segments.sample_spacing_px", "px", "least distance of these, search level", 2,
                  100},
    s.sample_spacing_px);
  f(ParameterInfo{"segments.max_shift_px", "px",
                  "alignment may move from the prediction, search level", 1, 50},
    s.max_shift_px);
  f(ParameterInfo{"segments.fit_inlier_px", "px",
                  "distance of a sample from the fitted line, search level", 0.1, 10},
    s.fit_inlier_px);
  f(ParameterInfo{"segments.search_samples", "", "epipolar searches per segment seed and frame", 3,
                  30},
    s.search_samples);
  f(ParameterInfo{"segments.min_edge_cosine", "", "between segment normal and epipolar line", 0.05,
                  1},
    s.min_edge_cosine);
  f(ParameterInfo{"segments.max_job_seeds", "", "segment seeds measured per frame", 1, 1000},
    s.max_job_seeds);
  f(ParameterInfo{"segments.promote_sigma", "",
                  "relative depth sigma below which a tracked seed becomes a landmark", 0.001, 1},
    s.promote_sigma);
  f(ParameterInfo{"segments.max_tracked", "", "per frame", 0, 500}, s.max_tracked);
  f(ParameterInfo{"segments.max_tries", "", "alignments of segments per frame", 0, 1000},
    s.max_tries);
  f(ParameterInfo{"segments.max_prediction_px", "px",
                  "a seed with more doubt across its line is not tracked", 0.1, 50},
    s.max_prediction_px);
  f(ParameterInfo{"segments.patches_per_segment", "", "for sparse alignment", 0, 20},
    s.patches_per_segment);
  f(ParameterInfo{"segments.max_patches", "", "of all segments, for sparse alignment", 0, 1000},
    s.max_patches);
  f(ParameterInfo{"segments.line_noise_px", "px", "across the line at its ends", 0.05, 10},
    s.line_noise_px);
  f(ParameterInfo{"segments.max_depth_px", "px",
                  "a depth with more doubt across the line does not enter the pose", 0, 50},
    s.max_depth_px);
  f(ParameterInfo{"segments.pose_sigma", "", "noise of a segment relative to a corner in the pose",
                  0.1, 50},
    s.pose_sigma);
  f(ParameterInfo{"segments.min_scale", "", "floor of the robust scale over line_noise_px", 0.01,
                  10},
    s.min_scale);
  f(ParameterInfo{"segments.max_error_px", "px", "distance of an end point from its line, inlier",
                  0.1, 50},
    s.max_error_px);
  f(ParameterInfo{"segments.max_failures", "",
                  "frames without it as an inlier before a segment is deleted", 1, 1000},
    s.max_failures);
}

/// The two-view start takes them when a run begins.
template <typename P, typename F>
void visitStart(P& p, F&& f) {
  auto& s = p.tracker.start;
  const auto row = [&](const char* key, const char* unit, const char* meaning, double minimum,
                       double maximum, auto& field) {
    f(ParameterInfo{key, unit, meaning, minimum, maximum, true}, field);
  };
  row("start.max_tracks", "", "grid cells of a reference frame", 20, 5000, s.max_tracks);
  row("start.min_tracks", "", "a reference with fewer live tracks is given up", 8, 1000,
      s.min_tracks);
  row("start.min_inliers", "", "points of the first map", 8, 1000, s.min_inliers);
  row("start.min_track_ratio", "", "live tracks over those at the start of a reference", 0, 1,
      s.min_track_ratio);
  row("start.renew_track_ratio", "", "below this share of live tracks a further reference begins",
      0, 1, s.renew_track_ratio);
  row("start.min_inlier_ratio", "", "of the live tracks", 0.01, 1, s.min_inlier_ratio);
  row("start.max_references", "", "alive at the same time", 1, 20, s.max_references);
  row("start.max_age", "frames", "after which a reference is given up", 1, 100000, s.max_age);
  row("start.min_disparity_px", "px",
      "median motion before two views are tried; 0: 1.5 % of the image width", 0, 500,
      s.min_disparity_px);
  row("start.min_parallax_px", "px", "what the best rotation must leave of the motion, median", 0,
      100, s.min_parallax_px);
  row("start.max_rms_px", "px", "of the joint refinement", 0.1, 20, s.max_rms_px);
  row("start.max_depth_sigma", "", "median relative uncertainty of depth", 0.001, 10,
      s.max_depth_sigma);
  row("start.noise_px", "px", "least assumed error of a track", 0.01, 5, s.noise_px);
  row("start.model_error", "",
      "error of the camera model (rolling shutter, focal length) over the motion by rotation", 0, 1,
      s.model_error);
  row("start.min_frames", "frames", "after the reference: a third view tests the first two", 1, 100,
      s.min_frames);
  row("start.max_samples", "", "of each random search over two views", 10, 10000, s.max_samples);
  row("start.refine_frames", "frames", "refined jointly, the current one included", 1, 50,
      s.refine_frames);
  row("start.half_patch", "px", "half side of a track's patch at the three finest levels", 2, 16,
      s.klt.half_patch);
  row("start.half_patch_coarse", "px", "the same at coarser levels", 2, 16,
      s.klt.half_patch_coarse);
  row("start.max_iterations", "", "of a track per level", 1, 200, s.klt.max_iterations);
  row("start.min_correlation", "", "of a track with its patch, zero mean and normalised", -1, 1,
      s.klt.min_correlation);
  row("start.image_noise", "grey", "weighs where a track is expected against its patch", 0.1, 100,
      s.klt.image_noise);
}

template <typename P, typename F>
void visitParameters(P& p, F&& f) {
  visitTracking(p, f);
  visitMapping(p, f);
  visitSegments(p, f);
  visitAdjustment(p, f);
  visitQuality(p, f);
  visitStart(p, f);
}

/// Fields without a row: calls f(reason, field).
template <typename P, typename F>
void visitFixed(P& p, F&& f) {
  f("the method decides", p.tracker.mapping.filter.rule);
  f("the method decides", p.tracker.mapping.segments.enabled);
  f("the tracker sets it for each attempt", p.tracker.reproject.coarser);
}

}  // namespace svoscope
