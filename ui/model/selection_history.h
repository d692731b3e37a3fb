// SPDX-License-Identifier: MIT
// What is known about the selected feature or seed in every snapshot still held.
#pragma once

#include <optional>
#include <vector>

#include "engine/runner/run_view.h"
#include "ui/model/ui_state.h"

namespace svoscope::ui {

Selection selectionOf(const FeatureView& feature);
const FeatureView* findFeature(const Snapshot& snapshot, const Selection& selection);
const SeedView* findSeed(const Snapshot& snapshot, std::int64_t id);
const MapPointView* findPoint(const Snapshot& snapshot, std::int64_t id);

class SelectionHistory {
 public:
  /// Extends by new snapshots; starts again if the selection or the run changed.
  void update(const RunView& run, const Selection& selection, const SnapshotPtr& latest);

  std::vector<float> frames, residual, depth, observations;                     ///< of features
  std::vector<float> seed_frames, mu, mu_lo, mu_hi, sigma_ratio, inlier_ratio;  ///< of seeds
  int last_seen = -1;  ///< last frame in which the feature was measured or the seed existed
  std::optional<SeedView> last_seed;

 private:
  void add(const Snapshot& snapshot);

  Selection selection_;
  int generation_ = -1;
  int next_ = 0;  ///< frame to look at next
};

}  // namespace svoscope::ui
