// SPDX-License-Identifier: MIT
// The seeds of a frame as a blob of differences: of every seed its id and the fields that changed
// since the frame before. A blob made without a frame before stands for itself.
#pragma once

#include <memory>
#include <unordered_map>
#include <vector>

#include "engine/recording/bytes.h"
#include "engine/snapshot/snapshot.h"

namespace svoscope {

/// The seeds of a frame, found by id.
class SeedIndex {
 public:
  using List = std::shared_ptr<const std::vector<SeedView>>;

  void set(List seeds);
  /// Null if it is not there. Cheap if asked for in about the order of the list.
  const SeedView* find(std::int64_t id) const;
  const List& list() const { return seeds_; }

 private:
  List seeds_;
  mutable std::size_t next_ = 0;                              ///< where the next one is expected
  mutable std::unordered_map<std::int64_t, std::size_t> at_;  ///< made when first needed
};

/// Appends the seeds in their order.
void encodeSeeds(const std::vector<SeedView>& seeds, const SeedIndex& before, ByteWriter& out);

/// The inverse; false if the blob is damaged. The places of the seeds are left as they were before.
bool decodeSeeds(ByteReader& in, const SeedIndex& before, std::vector<SeedView>& seeds);

}  // namespace svoscope
