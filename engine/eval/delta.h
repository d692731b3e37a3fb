// SPDX-License-Identifier: MIT
// The interval of the relative pose error, and the pose pairs that are one interval apart.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/base/result.h"
#include "engine/geometry/trajectory.h"

namespace svoscope {

struct Delta {
  enum class Unit { frames, seconds, metres };
  double value = 1;
  Unit unit = Unit::seconds;

  std::string text() const;  ///< "1s", "30f", "10m"
};

/// Parses "1s", "0.5s", "30f", "10m". Usage error otherwise, and for values that are not positive
/// or, for frames, not whole.
Result<Delta> parseDelta(const std::string& text);

/// Index pairs (i, j) with i < j that lie `delta` apart in `poses`.
/// Frames: by position. Metres: by path length. Seconds: by time.
/// Consecutive pairs share an end with the next pair and do not overlap; with `all_pairs` every
/// pose starts a pair with the pose nearest to the interval, kept within 10 % of it (seconds: or
/// 0.02 s, whichever is larger). May be empty.
std::vector<std::pair<int, int>> pairsApart(const Trajectory& poses, const Delta& delta,
                                            bool all_pairs);

}  // namespace svoscope
