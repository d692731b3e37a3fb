// SPDX-License-Identifier: MIT
// Jobs for the mapping thread, and its answers.
#include "engine/tracking/map_keeper.h"
#include "engine/tracking/mapping_request.h"

namespace svoscope {

void MapKeeper::requestMapping(const Frame& frame, const Frame& last,
                               const MappingParameters& mapping) {
  const Keyframe* latest = map_.findKeyframe(latest_keyframe_);
  const bool made_now = latest && latest->frame_index == frame.index;
  job_ = makeMappingJob({map_, frame, last, local_keyframes_, measured_seeds_,
                         made_now ? latest : nullptr, occupied_},
                        mapping);
  requestAdjustment(mapping);
}

/// One at a time: a problem built while another is being solved holds the poses of before it, and
/// would put them back.
void MapKeeper::requestAdjustment(const MappingParameters& p) {
  if (!adjustment_wanted_ || awaited_adjustment_ >= 0) return;
  adjustment_wanted_ = false;
  if (!p.local_ba.enabled) return;
  job_->adjustment = localProblem(map_, latest_keyframe_, p.local_ba, p.segments);
  job_->adjustment.timed = timed_;
  job_->adjustment.newest = latest_keyframe_;
  if (!job_->adjustment.empty()) awaited_adjustment_ = latest_keyframe_;
}

MapKeeper::Answer MapKeeper::apply(MappingResult result, const TrackerParameters& p, Frame& frame) {
  Answer answer;
  bringToScale(map_, result);
  applyMeasurements(result, p.mapping.filter, map_, log_, answer.tally);
  // Last: it changes the scale of what was measured before.
  const AdjustmentResult& adjustment = result.adjustment;
  if (adjustment.newest == awaited_adjustment_) awaited_adjustment_ = -1;
  answer.change =
      adoptAdjustment(adjustment, p.mapping.segments, p.quality.structure_iterations, map_, frame);
  return answer;
}

}  // namespace svoscope
