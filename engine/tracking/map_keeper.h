// SPDX-License-Identifier: MIT
// Owns the map and all bookkeeping about it: which keyframes are near, what the frame adds to the
// map, when a keyframe is made, the job for the mapping thread and its answer.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "engine/tracking/initializer.h"
#include "engine/tracking/map_adjustment.h"
#include "engine/tracking/registration.h"
#include "engine/tracking/seed_measuring.h"

namespace svoscope {

class MapKeeper {
 public:
  explicit MapKeeper(const Pinhole& camera) { map_.camera = camera; }
  /// Forgets the map. Its identifiers do not return if `keep_ids`: answers on their way, and what
  /// is kept by keyframe, still speak of the old map.
  void reset(bool keep_ids);
  const Map& map() const { return map_; }

  /// Before a frame is registered: seeds that ended in the last one (`last_index`) go, and those of
  /// keyframes long out of sight end.
  void beginFrame(int last_index);
  /// The first map, from a start; `frame` gets its pose and features.
  void beginMap(const InitializerOutput& start, const TrackerParameters& parameters, Frame& frame);
  /// The keyframes near the frame, also of a registration that was refused.
  void setLocalKeyframes(const std::vector<int>& ids) { local_keyframes_ = ids; }
  /// The frame was registered, and holds the features of the registration.
  void noteRegistration(const Registration& registration, const TrackerParameters& parameters,
                        const Frame& frame);
  /// The frame's matches enter the seeds.
  SeedTally measure(const std::vector<TrackedSeedMatch>& matches, const MappingParameters& mapping,
                    Frame& frame);
  /// Refines the landmarks seen in the frame.
  void refine(const TrackerParameters& parameters, Frame& frame);

  /// `required`: inliers below which the frame had been lost.
  KeyframeDecision considerKeyframe(const Frame& frame, int required,
                                    const KeyframeParameters& parameters) const;
  /// Makes the frame a keyframe and returns its id; one too many makes the farthest go.
  int insertKeyframe(const TrackerParameters& parameters, Frame& frame);

  /// Makes the frame's mapping job.
  void requestMapping(const Frame& frame, const Frame& last, const MappingParameters& mapping);
  std::optional<MappingJob> takeJob() { return std::exchange(job_, std::nullopt); }
  struct Answer {
    SeedTally tally;
    std::optional<KeyframeChange> change;  ///< that the frame went along with
  };
  /// Applies what a job found.
  Answer apply(MappingResult result, const TrackerParameters& parameters, Frame& frame);

  /// Local adjustment may be cut off by the clock.
  void setTimed(bool timed) { timed_ = timed; }
  void setInspected(bool on) { log_.inspected = on; }
  std::vector<SeedUpdateView> takeSeedUpdates() { return std::exchange(log_.updates, {}); }

 private:
  void limitKeyframes(int most, Frame& frame);
  void requestAdjustment(const MappingParameters& mapping);

  Map map_;
  std::vector<int> local_keyframes_;          ///< ids, nearest first
  OccupancyGrid occupied_;                    ///< cells of the frame that hold a feature
  std::vector<std::int64_t> measured_seeds_;  ///< by the tracker in this frame, sorted
  int latest_keyframe_ = -1, last_keyframe_frame_ = -1;
  std::optional<MappingJob> job_;
  bool adjustment_wanted_ = false;  ///< a keyframe came after the last problem was built
  int awaited_adjustment_ = -1;  ///< newest keyframe of the problem that is being solved; -1: none
  bool timed_ = false;
  SeedLog log_;
};

}  // namespace svoscope
