// SPDX-License-Identifier: MIT
// Every held update of the seeds that are looked at: the selected one and the pinned ones.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "engine/runner/run_view.h"

namespace svoscope::ui {

struct PanelContext;

struct SeedTrace {
  std::int64_t id = -1;
  std::vector<SeedUpdateView> updates;    ///< in the order of application
  std::vector<int> published;             ///< frame of the snapshot each came with, never falling
  std::optional<SeedView> last;           ///< newest state held
  int first_frame = -1, last_frame = -1;  ///< snapshots that have the seed

  /// Index of the last update at or before a frame; -1 if none.
  int lastAt(int frame) const;
};

class SeedTraces {
 public:
  static constexpr std::size_t kMostUpdates = 5000;  ///< of one seed

  /// Extends the traces of `ids` by new snapshots; drops those of others.
  void update(const RunView& run, const std::vector<std::int64_t>& ids, const SnapshotPtr& latest);
  const SeedTrace* find(std::int64_t id) const;

 private:
  struct Entry {
    SeedTrace trace;
    int next = 0;  ///< frame to look at next
  };
  static void add(SeedTrace& trace, const Snapshot& snapshot);

  std::map<std::int64_t, Entry> entries_;
  int generation_ = -1;
};

/// The update that the seed panels look at.
struct ViewedUpdate {
  const SeedTrace* trace = nullptr;        ///< null: no seed is selected, or nothing of it is held
  const SeedUpdateView* update = nullptr;  ///< null: no update is held
  int index = -1;
};
/// Brings the traces up to date and applies a wish to step.
ViewedUpdate viewedUpdate(PanelContext& c);
/// Looks at an update of the trace, and at its frame if the image is to follow.
void viewUpdate(PanelContext& c, const SeedTrace& trace, int index);
/// Says why there is nothing to show, and offers a seed; false if a seed is selected.
bool saysNoSeed(PanelContext& c, const ViewedUpdate& v);
/// Says why no update of the seed is held; false if there are some.
bool saysNoUpdate(const PanelContext& c, const SeedTrace& trace);

/// Which of two seeds has more to show: updates are kept of point seeds only. Then those still
/// open, just matched (both only if `open_first`), and with more updates.
bool showsMore(const SeedView& a, const SeedView& b, bool open_first);

bool isPinned(const PanelContext& c, std::int64_t id);
void togglePin(PanelContext& c, std::int64_t id);

/// Thresholds of the filter as they are set now.
struct FilterGates {
  double converged_fraction = 1.0 / 200;  ///< sigma over range
  double min_ratio = 0.5;                 ///< inlier ratio of a converged seed
  double reject_ratio = 0.08;
  double search_sigmas = 3;
};
FilterGates filterGates(const PanelContext& c);

/// True inverse distance in 1/map unit; 0 if unknown.
double trueInverseDistance(const PanelContext& c, const SeedView& seed);

/// sigma > 0 and all finite: the rule was computed and can be drawn.
bool drawable(const BeliefView& belief);
/// The belief of the first rule of the table that can be drawn; if none can, the last one's.
const BeliefView& firstComputed(const ByRule<BeliefView>& beliefs);
double inlierRatio(const BeliefView& belief);  ///< NaN if a + b is not positive

}  // namespace svoscope::ui
