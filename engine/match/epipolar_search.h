// SPDX-License-Identifier: MIT
// Search for a reference patch along its epipolar line in the current image, between the inverse
// distances mu - n sigma and mu + n sigma. "Inverse distance" is 1 / (length of the ray), so that
// a bearing f and inverse distance z give the point f / z, and z = 0 is at infinity.
#pragma once

#include <vector>

#include "engine/base/kinds.h"
#include "engine/frame/pyramid.h"
#include "engine/match/feature_alignment.h"
#include "engine/match/patch.h"

namespace svoscope {

struct EpipolarParameters {
  double search_sigmas = 3;        ///< half width n of the searched interval
  double step_px = 0.7;            ///< between samples, px of the search level
  int max_samples = 100;           ///< of a long line, those nearest the current estimate
  double max_score = 2000;         ///< zero-mean SSD per pixel, grey levels squared
  double short_line_px = 2;        ///< below: no scan, alignment from the middle
  double min_parallax_deg = 0.06;  ///< between the two rays
  double min_edge_cosine = 0.7;    ///< between edgelet gradient and epipolar line
  double pixel_noise = 1;          ///< sigma of a match along the line, px at level 0
};

/// What is searched for, and what is believed.
struct EpipolarQuery {
  const Pyramid* ref = nullptr;  ///< pyramid of the reference keyframe
  const Pyramid* cur = nullptr;
  Pinhole camera;
  SE3 T_cur_ref;
  Vec2 px_ref = Vec2::Zero();  ///< level-0 pixel in the reference
  Vec3 f_ref = Vec3::UnitZ();  ///< unit bearing of px_ref
  int level_ref = 0;
  FeatureType type = FeatureType::corner;
  Vec2 gradient_dir = Vec2::Zero();  ///< edgelets
  double mu = 1, sigma = 0;          ///< inverse distance, 1/map unit
};

struct EpipolarMatch {
  SearchOutcome outcome = SearchOutcome::none;
  Vec2 px = Vec2::Zero();            ///< level-0 pixel of the match
  int level = 0;                     ///< search level
  double inv_distance = 0;           ///< triangulated along the reference ray
  double tau = 0;                    ///< its sigma
  double score = 0;                  ///< zero-mean SSD per pixel of the best sample
  Vec2 gradient_dir = Vec2::Zero();  ///< edgelets: gradient in the current image, unit
};

EpipolarMatch searchEpipolar(const EpipolarQuery& query, const EpipolarParameters& parameters,
                             const FeatureAlignmentParameters& alignment);

/// The line that is searched and the patch that is sought, for display. Outcome `matched` if both
/// exist; `length_px` is the line's length on the search level.
struct SearchSetup {
  SearchOutcome outcome = SearchOutcome::none;
  Vec2 px_near = Vec2::Zero(), px_far = Vec2::Zero();  ///< level 0
  double length_px = 0;
  int level = 0;
  WarpedPatch patch;
};
SearchSetup prepareSearch(const EpipolarQuery& query, const EpipolarParameters& parameters);

/// Score of every sample of the search, for display. Empty if the search has no line.
struct ProfileSample {
  Vec2 px = Vec2::Zero();  ///< level 0
  double inv_distance = 0;
  double score = 0;  ///< zero-mean SSD per pixel
};
std::vector<ProfileSample> scoreProfile(const EpipolarQuery& query,
                                        const EpipolarParameters& parameters);

/// Angle at the point between the rays of the two cameras, radians; the point lies along f_ref.
double parallaxAt(const SE3& T_cur_ref, const Vec3& f_ref, double inv_distance);

/// Inverse distance along f_ref at which the point projects closest to `px_cur` (least squares on
/// the unit plane). Negative or infinite for diverging rays.
double triangulateInverseDistance(const Pinhole& camera, const SE3& T_cur_ref, const Vec3& f_ref,
                                  const Vec2& px_cur);

/// Sigma of the inverse distance caused by `pixel_noise` px along the epipolar line: law of sines
/// on the triangle (reference, current, point), as in REMODE (Pizzoli et al., ICRA 2014).
double inverseDistanceSigma(const SE3& T_cur_ref, const Vec3& f_ref, double inv_distance,
                            double pixel_noise, double focal);

}  // namespace svoscope
