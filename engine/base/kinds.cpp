// SPDX-License-Identifier: MIT
#include "engine/base/kinds.h"

namespace svoscope {

const char* searchOutcomeName(SearchOutcome outcome) {
  switch (outcome) {
    case SearchOutcome::none:
      return "not searched";
    case SearchOutcome::matched:
      return "matched";
    case SearchOutcome::no_match:
      return "no match";
    case SearchOutcome::out_of_view:
      return "out of view";
    case SearchOutcome::low_parallax:
      return "parallax too small";
    case SearchOutcome::edge_parallel:
      return "edge along the epipolar line";
    case SearchOutcome::tracked:
      return "measured by tracking";
  }
  return "unknown";
}

const char* seedEndingName(SeedEnding ending) {
  switch (ending) {
    case SeedEnding::none:
      return "alive";
    case SeedEnding::inlier_ratio:
      return "inlier ratio below the floor";
    case SeedEnding::no_depth:
      return "mean not in front of the camera";
    case SeedEnding::not_finite:
      return "belief not finite";
    case SeedEnding::keyframe_removed:
      return "keyframe removed";
    case SeedEnding::out_of_sight:
      return "keyframe long out of sight";
    case SeedEnding::promoted:
      return "became a landmark";
  }
  return "unknown";
}

const char* seedStatusName(SeedStatus status) {
  switch (status) {
    case SeedStatus::active:
      return "active";
    case SeedStatus::converged:
      return "converged";
    case SeedStatus::rejected:
      return "rejected";
    case SeedStatus::promoted:
      return "promoted";
  }
  return "unknown";
}

}  // namespace svoscope
