// SPDX-License-Identifier: MIT
// A segment found in the current image: patches of the reference view are aligned across the
// predicted line at several places, and a line is fitted robustly to where they went. The line is
// infinite; only the part inside the image is looked at.
#pragma once

#include <vector>

#include "engine/frame/pyramid.h"
#include "engine/geometry/segment.h"
#include "engine/mapping/segment_seed.h"
#include "engine/match/feature_alignment.h"

namespace svoscope {

struct SegmentQuery {
  const Pyramid* ref = nullptr;
  const Pyramid* cur = nullptr;
  Pinhole camera;
  SE3 T_cur_ref;
  SegmentAnchor anchor;                          ///< in the reference view
  Vec3 p_ref[2] = {Vec3::Zero(), Vec3::Zero()};  ///< end points, reference camera, map units
};

struct SegmentAlignment {
  bool ok = false;
  int samples = 0, inliers = 0;
  int level = 0;                                     ///< searched
  double t[2] = {0, 1};                              ///< visible part of the segment
  Vec2 predicted[2] = {Vec2::Zero(), Vec2::Zero()};  ///< ends of that part, level-0 px
  Vec2 px[2] = {Vec2::Zero(), Vec2::Zero()};         ///< the same on the measured line
  double rms_px = 0;                                 ///< of the inliers from the line, level-0 px
};

SegmentAlignment alignSegment(const SegmentQuery& query, const SegmentParameters& parameters,
                              const FeatureAlignmentParameters& alignment);

/// Line offset = a + b s through samples by the best pair, then least squares over its inliers.
struct LineFit {
  double a = 0, b = 0;
  int inliers = 0;
  double rms = 0;
};
struct LineSample {
  double s = 0, offset = 0, weight = 1;  ///< residuals are compared times the root of the weight
};
LineFit fitLine(const std::vector<LineSample>& samples, double inlier);

}  // namespace svoscope
