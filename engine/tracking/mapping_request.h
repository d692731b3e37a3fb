// SPDX-License-Identifier: MIT
// The mapping job of a frame: copies of all that its seeds and new keyframe need, so that it can be
// run by another thread.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/tracking/frame.h"
#include "engine/tracking/tracker_parameters.h"

namespace svoscope {

/// What a job is made from.
struct MappingRequest {
  const Map& map;
  const Frame& frame;
  const Frame& last;                          ///< the frame before, without pyramid if none
  const std::vector<int>& local_keyframes;    ///< ids, nearest first: their seeds are searched
  const std::vector<std::int64_t>& measured;  ///< seeds the frame has measured already, sorted
  const Keyframe* new_keyframe = nullptr;     ///< made of the frame: wants seeds; may be null
  const OccupancyGrid& occupied;              ///< cells of the frame that hold a feature
};

/// The job but for its adjustment. Segments come first: they decide the order of its keyframes.
MappingJob makeMappingJob(const MappingRequest& request, const MappingParameters& parameters);

}  // namespace svoscope
