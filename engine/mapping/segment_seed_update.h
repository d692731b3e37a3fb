// SPDX-License-Identifier: MIT
// Measuring segment seeds. The searches along a segment must agree on one line in space: inverse
// depth is linear along the image of a line, so places in between vote and two numbers come out,
// one for each end point. Where the epipolar line runs along the segment nothing is measured.
#pragma once

#include "engine/geometry/segment.h"
#include "engine/mapping/seed_update.h"

namespace svoscope {

SegmentAnchor makeSegmentAnchor(const Vec2& a, const Vec2& b, const Pinhole& camera, int level);

SegmentSeed makeSegmentSeed(const SegmentAnchor& anchor, double median_depth, double min_depth,
                            const DepthFilterParameters& parameters);

/// What is searched for, and where.
struct SegmentSearch {
  const Pyramid* ref = nullptr;
  const Pyramid* cur = nullptr;
  Pinhole camera;
  SE3 T_cur_ref;
  SegmentAnchor anchor;
  double mu[2] = {1, 1}, sigma[2] = {0, 0};  ///< inverse distances of the end points
};

/// Epipolar searches along the segment and their robust fit. Ids and frame are left to the caller.
SegmentMeasurement searchSegment(const SegmentSearch& search, const MappingParameters& parameters);

/// Both end points from a line measured by the tracker: rays against the line's plane.
SegmentMeasurement measureFromLine(const Pinhole& camera, const SE3& T_cur_ref,
                                   const SegmentAnchor& anchor, const Vec2 (&px)[2],
                                   const MappingParameters& parameters);

/// Applies a measurement to both beliefs and to the shared a, b and status.
void applySegmentMeasurement(SegmentSeed& seed, const SegmentMeasurement& m,
                             const DepthFilterParameters& parameters);

/// The segments' part of runMappingJob.
SegmentJobResult runSegmentJob(const MappingJob& job, const MappingParameters& parameters);

}  // namespace svoscope
