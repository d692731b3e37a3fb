// SPDX-License-Identifier: MIT
// Relative pose of two views from point correspondences, without knowing what the scene is like:
// planar, general, nearly forward motion, or no translation at all.
#pragma once

#include <string>
#include <vector>

#include "engine/geometry/se3.h"

namespace svoscope {

/// What two views allow us to say. Only `ok` comes with a pose to be used; `ambiguous` comes with
/// the alternatives that further frames may decide between.
enum class TwoViewVerdict {
  ok,
  too_few_tracks,
  rotation_only,  ///< a rotation explains the data: wait for translation
  low_parallax,   ///< a translation, but depths are too uncertain
  too_few_inliers,
  ambiguous,  ///< two poses explain the data equally well (a plane seen twice)
  poor_fit,   ///< residuals too large after refinement
};

enum class TwoViewModel { none, rotation, homography, essential };
const char* twoViewModelName(TwoViewModel model);

struct TwoViewOptions {
  double focal = 500;      ///< px; converts the limits below to the unit plane
  double sigma_px = 0.7;   ///< noise of a correspondence, px
  double inlier_px = 2.0;  ///< distance from the epipolar line of an inlier, px
  int min_tracks = 20;     ///< correspondences needed at all
  int min_inliers = 15;
  double min_inlier_ratio = 0.5;
  double min_disparity_px = 3.0;      ///< median of what is left after the best rotation
  double max_candidate_ratio = 1.15;  ///< cost of an alternative pose relative to the best
  int max_samples = 200;              ///< of each random search
  unsigned seed = 1;                  ///< equal input and seed: bit-identical output
};

/// One explanation of the correspondences.
struct TwoViewPose {
  SE3 T_cur_ref;                            ///< |t| = 1
  TwoViewModel model = TwoViewModel::none;  ///< what it was found by
  double cost = 0;  ///< mean truncated squared error, in units of sigma_px^2
  int inliers = 0;  ///< within inlier_px and not behind a camera
};

struct TwoViewResult {
  TwoViewVerdict verdict = TwoViewVerdict::too_few_tracks;
  std::string reason;  ///< one line with the numbers behind the verdict
  SE3 T_cur_ref;       ///< |t| = 1; the best pose
  TwoViewModel model = TwoViewModel::none;
  std::vector<TwoViewPose> candidates;  ///< best first; more than one if ambiguous
  std::vector<bool> inlier;             ///< one per correspondence, for the best pose
  std::vector<double> inv_depth;        ///< in ref, 1 / |t|; 0 for outliers
  double disparity_px = 0;              ///< median over correspondences
  double rotation_residual_px = 0;      ///< median after the best rotation
  double parallax_deg = 0;              ///< median over inliers
  double rms_px = 0;                    ///< of inliers, after two-view bundle adjustment
  double gric_rotation = 0, gric_homography = 0, gric_essential = 0;  ///< lower is better
  int inliers = 0;
};

/// x_ref and x_cur: corresponding positions on the unit plane, same length. Finds a rotation, a
/// homography and an essential matrix robustly, compares them by GRIC (Torr, IJCV 2002) to tell
/// a rotation or a plane, refines every pose that follows from them and keeps the one that
/// explains most. `hints`: poses worth trying besides, e.g. those of an earlier attempt.
TwoViewResult estimateTwoView(const std::vector<Vec2>& x_ref, const std::vector<Vec2>& x_cur,
                              const TwoViewOptions& options, const std::vector<SE3>& hints = {});

}  // namespace svoscope
