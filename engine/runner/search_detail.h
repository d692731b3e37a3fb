// SPDX-License-Identifier: MIT
// What one epipolar search saw, recomputed from snapshots on demand: score profile and patches. A
// pure function of published values, so that the user interface may call it in its own thread.
#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/snapshot/snapshot.h"

namespace svoscope {

struct SearchSample {
  Vec2f px = Vec2f::Zero();  ///< level 0 of the searched frame
  float inv_distance = 0;    ///< along the seed's ray, 1/map unit
  float score = 0;           ///< zero-mean SSD per pixel, grey levels squared
};

struct SearchDetail {
  SearchOutcome outcome = SearchOutcome::none;
  std::vector<SearchSample>
      profile;  ///< by inverse distance; empty: too short to scan, or not searched
  int best = -1,
      second =
          -1;  ///< indices into profile; second: best one at least 3 px of the search level away
  float max_score = 0;  ///< accepted below
  int search_level = 0;
  Vec2f px_near = Vec2f::Zero(), px_far = Vec2f::Zero();  ///< ends of the searched line, level 0
  Vec2f px_match = Vec2f::Zero();                         ///< after sub-pixel alignment
  cv::Mat patch_reference;  ///< CV_8UC1 24x24 around the seed in its keyframe, its level, unwarped
  cv::Mat patch_warped;     ///< CV_8UC1 8x8, as searched for
  cv::Mat patch_match;      ///< CV_8UC1 8x8, at the match; empty if none
};

/// Explains the update of `seed` made on `searched` (its image and pose). The belief before the
/// update is taken from `update`. New seeds are also measured in frames before their keyframe: the
/// keyframe is then taken from `later`, a snapshot that knows it. Input error if the keyframe's
/// image is no longer held.
Result<SearchDetail> explainSearch(const SeedView& seed, const SeedUpdateView& update,
                                   const Snapshot& searched, const RunInfo& info,
                                   const Snapshot* later = nullptr);

}  // namespace svoscope
