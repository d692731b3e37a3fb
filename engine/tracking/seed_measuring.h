// SPDX-License-Identifier: MIT
// Measurements entering the seeds of the map: those made by tracking a frame, once its pose is
// final, and those that a mapping job brought back.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/tracking/frame.h"
#include "engine/tracking/reprojector.h"

namespace svoscope {

/// What measurements did to the seeds of the map.
struct SeedTally {
  int updates = 0, segment_updates = 0;  ///< measurements of point and of segment seeds
  int converged = 0, rejected = 0;       ///< seeds of both kinds
};

/// Updates of point seeds, kept for display while someone looks.
struct SeedLog {
  bool inspected = false;  ///< else nothing is kept, and only the rule in use runs
  std::vector<SeedUpdateView> updates;
};

/// Seeds matched in the frame are measured with its final pose; its features take their new places.
/// Returns the ids of the seeds measured, sorted.
std::vector<std::int64_t> measureMatches(const std::vector<TrackedSeedMatch>& matches,
                                         const MappingParameters& parameters, Map& map,
                                         Frame& frame, SeedLog& log, SeedTally& tally);

/// The same for the frame's segments.
void measureSegments(const MappingParameters& parameters, Map& map, Frame& frame, SeedTally& tally);

/// Applies the measurements of a mapping job, which are in the scale of the map, and adds its new
/// seeds. Seeds and keyframes that are gone are passed over.
void applyMeasurements(const MappingResult& result, const DepthFilterParameters& filter, Map& map,
                       SeedLog& log, SeedTally& tally);

/// Inverse distances of an answer are in the scale their keyframes had when the job was made:
/// brings them to that of today.
void bringToScale(const Map& map, MappingResult& result);

}  // namespace svoscope
