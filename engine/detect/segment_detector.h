// SPDX-License-Identifier: MIT
// Line segments of a keyframe: the line segment detector (von Gioi et al., PAMI 2010) of OpenCV,
// merged where collinear, the longest kept, spread over the image.
#pragma once

#include <array>
#include <vector>

#include "engine/frame/pyramid.h"

namespace svoscope {

struct SegmentDetectorParameters {
  int level = 0;                   ///< pyramid level searched
  double min_length_px = 40;       ///< shortest segment, px at 640 px width; grows with the image
  double merge_angle_deg = 2;      ///< pieces of one line differ in direction by less ...
  double merge_distance_px = 1.5;  ///< ... lie this close to the longer one's line ...
  double merge_gap_px = 12;        ///< ... and leave a gap of at most this
  double separation_px = 6;        ///< between parallel segments kept, px
  int cell_px = 80;                ///< grid cell for midpoints, px at 640 px width
  int per_cell = 3;                ///< segments whose midpoint lies in one cell, longest first
  int max_segments = 60;           ///< per keyframe, those already tracked included
};

/// Level-0 pixels. Directed: the brighter side is always on the same hand.
struct DetectedSegment {
  Vec2 px[2] = {Vec2::Zero(), Vec2::Zero()};

  double length() const { return (px[1] - px[0]).norm(); }
};

/// Joins pieces of one line. Longest first in the result.
std::vector<DetectedSegment> mergeCollinear(std::vector<DetectedSegment> segments,
                                            const SegmentDetectorParameters& parameters);

/// New segments, longest first; none that shows the same edge as one of `tracked`.
std::vector<DetectedSegment> detectSegments(const Pyramid& pyramid,
                                            const SegmentDetectorParameters& parameters,
                                            const std::vector<DetectedSegment>& tracked);

}  // namespace svoscope
