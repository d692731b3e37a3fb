// SPDX-License-Identifier: MIT
// Where the features of the shown frame were in the frames before.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/runner/run_view.h"

namespace svoscope::ui {

class Trails {
 public:
  /// Positions of each feature of `shown`, newest first, over up to `frames` frames back.
  const std::vector<std::vector<Vec2f>>& update(const RunView& run, const Snapshot& shown,
                                                int frames);

 private:
  std::uint64_t sequence_number_ = 0;
  int frames_ = 0, generation_ = -1;
  std::vector<std::vector<Vec2f>> trails_;
};

}  // namespace svoscope::ui
