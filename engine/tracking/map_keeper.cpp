// SPDX-License-Identifier: MIT
// The map from frame to frame. Keyframes: map_keeper_keyframes.cpp. Jobs: map_keeper_jobs.cpp.
#include "engine/tracking/map_keeper.h"

#include <algorithm>

#include "engine/tracking/first_map.h"
#include "engine/tracking/landmark_keeping.h"

namespace svoscope {

namespace {

constexpr int kSeedMemoryFrames = 60;

}  // namespace

void MapKeeper::reset(bool keep_ids) {
  MapKeeper fresh(map_.camera);
  fresh.timed_ = timed_;
  fresh.log_.inspected = log_.inspected;
  if (keep_ids) {
    fresh.map_.next_id = map_.next_id;
    fresh.map_.next_keyframe_id = map_.next_keyframe_id;
  }
  *this = std::move(fresh);
}

/// Ended seeds stay for one frame, so that its snapshot shows how they ended. Keyframes long out of
/// sight lose theirs: the cost of a frame must not grow with the path.
void MapKeeper::beginFrame(int last_index) {
  for (const int id : local_keyframes_) {
    if (Keyframe* keyframe = map_.findKeyframe(id)) keyframe->last_local_frame = last_index;
  }
  measured_seeds_.clear();
  map_.orphans.clear();
  map_.segment_orphans.clear();
  for (auto& [id, keyframe] : map_.keyframes) {
    if (last_index - std::max(keyframe.last_local_frame, keyframe.frame_index) > kSeedMemoryFrames)
      map_.endSeeds(keyframe, SeedEnding::out_of_sight);
    dropEnded(keyframe.seeds);
    dropEnded(keyframe.segment_seeds);
  }
}

void MapKeeper::beginMap(const InitializerOutput& start, const TrackerParameters& p, Frame& frame) {
  local_keyframes_ = {buildFirstMap(start, map_, frame)};
  occupied_ = OccupancyGrid(map_.camera.width, map_.camera.height,
                            scaledCell(p.reproject.cell_px, map_.camera.width));
  for (const TrackedFeature& f : frame.features) occupied_.take(f.anchor.px);
}

void MapKeeper::noteRegistration(const Registration& registration, const TrackerParameters& p,
                                 const Frame& frame) {
  occupied_ = registration.occupied;
  countTries(registration, frame, p, map_);
}

SeedTally MapKeeper::measure(const std::vector<TrackedSeedMatch>& matches,
                             const MappingParameters& mapping, Frame& frame) {
  SeedTally tally;
  measured_seeds_ = measureMatches(matches, mapping, map_, frame, log_, tally);
  measureSegments(mapping, map_, frame, tally);
  return tally;
}

void MapKeeper::refine(const TrackerParameters& p, Frame& frame) {
  refinePoints(p.quality.structure_iterations, map_, frame);
  refineSegments(p.mapping.segments.line_noise_px, p.quality.structure_iterations, map_, frame);
}

}  // namespace svoscope
