// SPDX-License-Identifier: MIT
#include "engine/recording/names.h"

namespace svoscope {

using Names = std::vector<const char*>;

template <>
const Names& namesOf<TrackingState>() {
  static const Names names{"initializing", "tracking", "lost"};
  return names;
}

template <>
const Names& namesOf<EventKind>() {
  static const Names names{"info",    "initialized", "keyframe", "lost", "relocalized",
                           "warning", "reset",       "finished", "error"};
  return names;
}

template <>
const Names& namesOf<FeatureType>() {
  static const Names names{"corner", "edgelet", "segment"};
  return names;
}

template <>
const Names& namesOf<FeatureOrigin>() {
  static const Names names{"landmark", "converged_seed", "unconverged_seed", "track"};
  return names;
}

template <>
const Names& namesOf<FeatureStatus>() {
  static const Names names{"inlier", "outlier", "not_aligned", "followed"};
  return names;
}

template <>
const Names& namesOf<SeedStatus>() {
  static const Names names{"active", "converged", "rejected", "promoted"};
  return names;
}

template <>
const Names& namesOf<SearchOutcome>() {
  static const Names names{"none",         "matched",       "no_match", "out_of_view",
                           "low_parallax", "edge_parallel", "tracked"};
  return names;
}

template <>
const Names& namesOf<SeedEnding>() {
  static const Names names{"none",       "inlier_ratio",     "no_depth",
                           "not_finite", "keyframe_removed", "out_of_sight",
                           "promoted"};
  return names;
}

}  // namespace svoscope
