// SPDX-License-Identifier: MIT
// Tracking of single patches over many frames (Lucas-Kanade, inverse compositional, coarse to
// fine) against a template that is never replaced: no drift. Positions are pixels of level 0;
// level coordinates are u_L = (u + 0.5) / 2^L - 0.5.
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "engine/base/types.h"

namespace svoscope {

struct KltParameters {
  int half_patch = 8;            ///< px; patch of 2h x 2h at the three finest levels
  int half_patch_coarse = 4;     ///< px; at coarser levels, where large patches leave the image
  int max_iterations = 20;       ///< per level
  double min_correlation = 0.8;  ///< zero-mean normalised correlation at the end
  double image_noise = 4;        ///< grey levels; weighs the prior of a track against its patch
};

/// Patch of the reference frame at all levels at which it fits.
struct KltTemplate {
  struct Level {
    int half = 0;
    bool usable = false;
    Mat2 H = Mat2::Zero();             ///< of the zero-mean gradients
    std::vector<float> value, gx, gy;  ///< zero-mean each: the offset of brightness drops out
    float norm = 0;                    ///< of value
  };
  std::vector<Level> levels;
  Mat2 A_cur_ref = Mat2::Identity();  ///< warp it was cut out with
};

/// Cuts out the template around px_ref, warped so that it looks as in a current frame in which
/// the neighbourhood is mapped by A_cur_ref (turned, scaled).
KltTemplate makeKltTemplate(const std::vector<cv::Mat>& pyramid, const Vec2& px_ref,
                            const Mat2& A_cur_ref, const KltParameters& parameters);

/// Where a track is expected, px, and how sure that is. An edge is not localised along itself:
/// there the prior decides. Infinite sigma: no prior.
struct KltPrior {
  Vec2 px = Vec2::Zero();
  double sigma = 1e9;
};

struct KltResult {
  Vec2 px = Vec2::Zero();
  double correlation = -1;  ///< zero-mean normalised, level 0
  bool ok = false;
};

/// Finds the template in `pyramid` (CV_8U, level 0 first) from the guess.
KltResult trackKlt(const KltTemplate& patch, const std::vector<cv::Mat>& pyramid, const Vec2& guess,
                   const KltPrior& prior, const KltParameters& parameters);

}  // namespace svoscope
