// SPDX-License-Identifier: MIT
// The words that every part of the program uses for features and seeds: what kind they are, where
// they come from and how they end.
#pragma once

#include <cstdint>

namespace svoscope {

enum class FeatureType : std::uint8_t { corner, edgelet, segment };
enum class FeatureOrigin : std::uint8_t { landmark, converged_seed, unconverged_seed, track };
enum class FeatureStatus : std::uint8_t {
  inlier,
  outlier,      ///< aligned, but rejected by pose refinement
  not_aligned,  ///< projected into the image, alignment failed
  followed,  ///< segments: aligned and near its line, kept out of the pose as its depth is in doubt
};

enum class SeedStatus : std::uint8_t { active, converged, rejected, promoted };
enum class SearchOutcome : std::uint8_t {
  none,  ///< not searched in this frame
  matched,
  no_match,  ///< best score above the limit, or sub-pixel alignment diverged
  out_of_view,
  low_parallax,
  edge_parallel,  ///< gradient nearly perpendicular to the epipolar line
  tracked,        ///< measured by the tracker itself
};
/// Why a seed is no longer measured.
enum class SeedEnding : std::uint8_t {
  none,              ///< it lives
  inlier_ratio,      ///< a / (a + b) fell below the floor
  no_depth,          ///< its mean is at or behind infinity
  not_finite,        ///< its belief is not a number
  keyframe_removed,  ///< its keyframe left the map
  out_of_sight,      ///< its keyframe was not seen for long
  promoted,          ///< it became a landmark
};
const char* seedEndingName(SeedEnding ending);
const char* searchOutcomeName(SearchOutcome outcome);
const char* seedStatusName(SeedStatus status);

}  // namespace svoscope
