// SPDX-License-Identifier: MIT
#include "ui/panels/scene/trails.h"

#include <unordered_map>

#include "ui/model/selection_history.h"

namespace svoscope::ui {

namespace {

std::uint64_t keyOf(const FeatureView& f) {
  return (static_cast<std::uint64_t>(f.id) << 3) | static_cast<std::uint64_t>(selectionOf(f).kind);
}

}  // namespace

const std::vector<std::vector<Vec2f>>& Trails::update(const RunView& run, const Snapshot& shown,
                                                      int frames) {
  const int generation = run.generation();
  if (shown.sequence_number == sequence_number_ && frames == frames_ && generation == generation_) {
    return trails_;
  }
  sequence_number_ = shown.sequence_number;
  frames_ = frames;
  generation_ = generation;
  trails_.assign(shown.features.size(), {});
  std::unordered_map<std::uint64_t, std::size_t> alive;  // seen in all frames so far
  for (std::size_t i = 0; i < shown.features.size(); ++i) {
    if (shown.features[i].status != FeatureStatus::inlier) continue;
    alive[keyOf(shown.features[i])] = i;
    trails_[i].push_back(shown.features[i].px);
  }
  for (int back = 1; back <= frames && !alive.empty(); ++back) {
    const SnapshotPtr s = run.valuesAt(shown.record.index - back);
    if (!s) break;
    std::unordered_map<std::uint64_t, std::size_t> still;
    for (const FeatureView& f : s->features) {
      const auto found = alive.find(keyOf(f));
      if (found == alive.end() || f.status == FeatureStatus::not_aligned) continue;
      trails_[found->second].push_back(f.px);
      still.insert(*found);
    }
    alive = std::move(still);
  }
  return trails_;
}

}  // namespace svoscope::ui
