// SPDX-License-Identifier: MIT
// The epipolar search of the update looked at, explained once per update.
#pragma once

#include <optional>

#include "engine/runner/run_view.h"
#include "engine/runner/search_detail.h"

namespace svoscope::ui {

class SearchCache {
 public:
  /// `published`: frame of the snapshot that brought the update. Null with a reason in problem() if
  /// the frame is no longer held, or the engine cannot tell.
  const SearchDetail* find(const RunView& run, const SeedView& seed, const SeedUpdateView& update,
                           int update_index, int published);
  const std::string& problem() const { return problem_; }
  /// Changes with the content; for textures.
  std::uint64_t version() const { return version_; }
  int computed() const { return computed_; }

 private:
  struct Key {
    std::int64_t seed = -1;
    int frame = -1, update = -1, generation = -1;
    bool operator==(const Key& o) const {
      return seed == o.seed && frame == o.frame && update == o.update && generation == o.generation;
    }
  };
  Key key_;
  std::optional<SearchDetail> detail_;
  std::string problem_;
  std::uint64_t version_ = 0;
  int computed_ = 0;
};

/// Corners in the reference image of what the 8x8 patch covers in the searched one, by the affine
/// warp at the belief's distance; empty if it cannot be told.
std::vector<Vec2f> warpedFootprint(const SeedView& seed, const SeedUpdateView& update,
                                   const Snapshot& searched, const Pinhole& camera,
                                   int search_level);

/// What became of the best sample: "best, accepted", "best, above the limit", ...
std::string bestSampleText(const SearchDetail& detail);
/// The measurement was made of the best sample.
bool bestAccepted(const SearchDetail& detail);

std::string profileCsv(const SearchDetail& detail, std::int64_t seed, int frame);

}  // namespace svoscope::ui
