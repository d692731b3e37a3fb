// SPDX-License-Identifier: MIT
// Segments as the values of a snapshot.
#pragma once

#include "engine/snapshot/seed_placement.h"
#include "engine/tracking/tracker.h"

namespace svoscope {

FeatureView segmentFeatureView(const TrackedSegment& segment, const Tracker& tracker);
/// `depth`: true depth image of the keyframe, may be empty.
SeedView segmentSeedView(const SegmentSeed& seed, const Tracker& tracker,
                         const SeedPlacement& placement, const cv::Mat& depth);
MapPointView segmentPointView(const SegmentLandmark& segment);

}  // namespace svoscope
