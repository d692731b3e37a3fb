// SPDX-License-Identifier: MIT
// The life of a seed, of a point or of a segment alike: it is made at a keyframe, measured, found
// converged, and ends once for one reason. What is believed of its depth is kept by the seeds
// themselves (map.h, segment_seed.h).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/base/kinds.h"
#include "engine/mapping/depth_filter.h"

namespace svoscope {

struct DepthFilterParameters;

struct SeedLife {
  std::int64_t id = -1;
  int keyframe_id = -1;
  double range = 1;  ///< R, width of the uniform component of the filter, 1/map unit
  SeedStatus status = SeedStatus::active;
  SeedEnding ending = SeedEnding::none;
  SearchOutcome outcome = SearchOutcome::none;  ///< of the last frame
  int updates = 0, failures = 0;
  int last_frame = -1;  ///< last frame with a successful measurement
};

/// Is measured and may be tracked.
inline bool alive(const SeedLife& seed) {
  return seed.status == SeedStatus::active || seed.status == SeedStatus::converged;
}

/// Ends a seed, as a landmark if promoted. One that has ended before keeps its ending.
void endSeed(SeedLife& seed, SeedEnding ending);

/// What a search says of the depth.
enum class Evidence : std::uint8_t { none, measured, missed };

/// Notes the outcome of a search in `frame_index` and counts it. An ended seed takes no notice.
Evidence noteSearch(SeedLife& seed, SearchOutcome outcome, int frame_index);

/// Decides from the beliefs after a search whether the seed has converged or ends. All `count`
/// beliefs share the inlier ratio of the first; each must have converged, none may be without
/// depth.
void judge(SeedLife& seed, const Belief* beliefs, std::size_t count,
           const DepthFilterParameters& parameters);

/// The seed with this id, null if there is none; `seeds` are in order of id.
template <class S>
S* findById(std::vector<S>& seeds, std::int64_t id) {
  const auto it = std::lower_bound(seeds.begin(), seeds.end(), id,
                                   [](const S& s, std::int64_t value) { return s.id < value; });
  return it != seeds.end() && it->id == id ? &*it : nullptr;
}

/// For a new frame: seeds that have ended go, the others have not been searched yet.
template <class S>
void dropEnded(std::vector<S>& seeds) {
  seeds.erase(std::remove_if(seeds.begin(), seeds.end(), [](const S& s) { return !alive(s); }),
              seeds.end());
  for (S& seed : seeds) seed.outcome = SearchOutcome::none;
}

}  // namespace svoscope
