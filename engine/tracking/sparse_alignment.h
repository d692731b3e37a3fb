// SPDX-License-Identifier: MIT
// Sparse image alignment (Forster et al., ICRA 2014, section IV-A): the motion between two frames
// that minimises the photometric error of 4x4 patches around points of known depth, inverse
// compositional, coarse to fine, with one brightness gain and offset for the frame.
#pragma once

#include <vector>

#include "engine/frame/pyramid.h"
#include "engine/geometry/camera.h"
#include "engine/geometry/se3.h"

namespace svoscope {

struct SparseAlignmentParameters {
  int max_level = 4;          ///< coarsest pyramid level used
  int min_level = 2;          ///< finest
  int max_iterations = 12;    ///< per level
  double min_step_px = 0.01;  ///< mean image motion of a step, px of the level
  bool estimate_gain = true;  ///< gain and offset of the frame
  int max_patches = 300;      ///< of a frame with more, every n-th is used
};

/// A patch of the reference frame.
struct AlignmentPatch {
  Vec2 px_ref = Vec2::Zero();  ///< level 0
  Vec3 p_ref = Vec3::Zero();   ///< the point in the reference camera, map units
};

struct SparseAlignmentResult {
  bool ok = false;  ///< enough patches and a finite motion
  SE3 T_cur_ref;
  double gain = 1;     ///< current = gain * reference + offset
  double offset = 0;   ///< grey levels
  double rmse = 0;     ///< grey levels, finest level, robustly weighted
  int patches = 0;     ///< visible in both, finest level
  int iterations = 0;  ///< over all levels
};

/// Mean squared error of a motion at one level, grey levels squared, gain and offset removed;
/// infinite if fewer than a third of the patches are visible. Used to compare predictions.
double photometricError(const Pyramid& ref, const Pyramid& cur, const Pinhole& camera,
                        const std::vector<AlignmentPatch>& patches, const SE3& T_cur_ref,
                        int level);

SparseAlignmentResult alignSparse(const Pyramid& ref, const Pyramid& cur, const Pinhole& camera,
                                  const std::vector<AlignmentPatch>& patches, const SE3& T_init,
                                  const SparseAlignmentParameters& parameters);

/// d px / d twist of a point moved by exp(twist) (translation, rotation), px at level 0.
Mat26 pixelTwistJacobian(const Pinhole& camera, const Vec3& p);

}  // namespace svoscope
