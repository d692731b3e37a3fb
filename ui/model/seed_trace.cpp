// SPDX-License-Identifier: MIT
#include "ui/model/seed_trace.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <tuple>

#include "ui/panels/panel_context.h"
#include "ui/widgets/controls.h"

namespace svoscope::ui {

int SeedTrace::lastAt(int frame) const {
  return static_cast<int>(std::upper_bound(published.begin(), published.end(), frame) -
                          published.begin()) -
         1;
}

void SeedTraces::add(SeedTrace& t, const Snapshot& s) {
  if (s.seed_updates) {
    for (const SeedUpdateView& u : *s.seed_updates) {
      if (u.seed_id != t.id || t.updates.size() >= kMostUpdates) continue;
      t.updates.push_back(u);
      t.published.push_back(s.record.index);
    }
  }
  if (const SeedView* seed = findSeed(s, t.id)) {
    t.last = *seed;
    if (t.first_frame < 0) t.first_frame = s.record.index;
    t.last_frame = s.record.index;
  }
}

void SeedTraces::update(const RunView& run, const std::vector<std::int64_t>& ids,
                        const SnapshotPtr& latest) {
  const int generation = run.generation();
  if (generation != generation_) entries_.clear();
  generation_ = generation;
  for (auto it = entries_.begin(); it != entries_.end();) {
    it = std::find(ids.begin(), ids.end(), it->first) == ids.end() ? entries_.erase(it)
                                                                   : std::next(it);
  }
  if (!latest) return;
  const int first = run.status().history_first;
  for (const std::int64_t id : ids) {
    Entry& e = entries_[id];
    e.trace.id = id;
    for (e.next = std::max(e.next, first); e.next <= latest->record.index; ++e.next) {
      if (const SnapshotPtr s = run.valuesAt(e.next)) add(e.trace, *s);
    }
  }
}

const SeedTrace* SeedTraces::find(std::int64_t id) const {
  const auto it = entries_.find(id);
  return it == entries_.end() ? nullptr : &it->second.trace;
}

ViewedUpdate viewedUpdate(PanelContext& c) {
  SeedOptions& o = c.state.seed;
  std::vector<std::int64_t> ids = o.pinned;
  const Selection& selected = c.state.selection;
  if (selected.kind == Selection::Kind::seed) ids.push_back(selected.id);
  c.cache<SeedTraces>().update(c.run, ids, c.latest);
  ViewedUpdate v;
  if (selected.kind != Selection::Kind::seed) return v;
  v.trace = c.cache<SeedTraces>().find(selected.id);
  if (!v.trace) return v;
  const int count = static_cast<int>(v.trace->updates.size());
  if (o.update_frame != c.viewedFrame() || o.update_seed != selected.id) o.update = -1;
  v.index = o.update >= 0 ? std::min(o.update, count - 1) : v.trace->lastAt(c.viewedFrame());
  if (o.step_request != 0 && count > 0) {
    v.index = std::clamp(v.index + std::exchange(o.step_request, 0), 0, count - 1);
    viewUpdate(c, *v.trace, v.index);
  }
  o.shown_update = v.index + 1;
  o.held_updates = count;
  if (v.index >= 0) v.update = &v.trace->updates[static_cast<std::size_t>(v.index)];
  return v;
}

void viewUpdate(PanelContext& c, const SeedTrace& trace, int index) {
  SeedOptions& o = c.state.seed;
  if (index < 0 || index >= static_cast<int>(trace.updates.size())) return;
  // Where it was published, so that the frame's other panels show the state after this update.
  const int frame = trace.published[static_cast<std::size_t>(index)];
  if (o.image_follows && frame >= c.status.history_first) c.view(frame);
  o.update = index;
  o.update_frame = c.viewedFrame();
  o.update_seed = trace.id;
}

bool saysNoSeed(PanelContext& c, const ViewedUpdate& v) {
  if (v.trace && (v.trace->last || !v.trace->updates.empty())) return false;
  if (!c.latest) {
    saysWhyEmpty(c);
    return true;
  }
  const bool selected = c.state.selection.kind == Selection::Kind::seed;
  const SeedView* best = nullptr;
  if (c.snapshot && c.snapshot->seeds) {
    for (const SeedView& s : *c.snapshot->seeds) {
      if (s.visible && (!best || showsMore(s, *best, false))) best = &s;
    }
  }
  ImGui::BeginDisabled(!best);
  if (button("Select a seed", {"The visible point seed with most updates"}) && best) {
    c.state.selection = {Selection::Kind::seed, best->id};
  }
  ImGui::EndDisabled();
  emptyState(selected ? "Nothing of this seed is held" : "No seed selected",
             best ? "Click a seed in the image, or take the one with most updates"
                  : "Seeds appear after the two-view start; click one in the image");
  return true;
}

bool saysNoUpdate(const PanelContext& c, const SeedTrace& trace) {
  if (!trace.updates.empty()) return false;
  if (trace.last && trace.last->type == FeatureType::segment) {
    emptyState("Updates of segment seeds are not kept",
               "Choose the seed of a corner or an edgelet");
  } else if (trace.last && trace.last->updates + trace.last->failures == 0) {
    emptyState("No update of this seed yet", "It was made, but not searched for");
  } else {
    emptyState("No update of this seed is held",
               format("The history keeps frames from %d on", c.status.history_first));
  }
  return true;
}

bool showsMore(const SeedView& a, const SeedView& b, bool open_first) {
  const auto rank = [open_first](const SeedView& s) {
    const bool point = s.type != FeatureType::segment, open = s.status == SeedStatus::active;
    const bool matched = s.outcome == SearchOutcome::matched;
    return std::tuple(point, s.updates > 0, open_first ? (open ? 2 : 0) + (matched ? 1 : 0) : 0,
                      s.updates);
  };
  return rank(a) > rank(b);
}

bool isPinned(const PanelContext& c, std::int64_t id) {
  const auto& pinned = c.state.seed.pinned;
  return std::find(pinned.begin(), pinned.end(), id) != pinned.end();
}

void togglePin(PanelContext& c, std::int64_t id) {
  constexpr std::size_t kMost = 12;
  auto& pinned = c.state.seed.pinned;
  const auto it = std::find(pinned.begin(), pinned.end(), id);
  if (it != pinned.end())
    pinned.erase(it);
  else if (pinned.size() < kMost)
    pinned.push_back(id);
  else
    c.state.toasts.add(format("%d seeds are pinned, unpin one first", static_cast<int>(kMost)));
}

FilterGates filterGates(const PanelContext& c) {
  FilterGates gates;
  for (const ParameterView& p : c.run.parameters()) {
    const auto take = [&](const char* key, double& value) {
      if (p.key == key) value = std::atof(p.value.c_str());
    };
    take("filter.converged_sigma", gates.converged_fraction);
    take("filter.min_inlier_ratio", gates.min_ratio);
    take("filter.reject_inlier_ratio", gates.reject_ratio);
    take("search.sigmas", gates.search_sigmas);
  }
  return gates;
}

double trueInverseDistance(const PanelContext& c, const SeedView& seed) {
  const TruthState& truth = c.caches.truth.state();
  if (!(seed.true_inv_distance > 0) || !truth.valid || !(truth.scale > 0)) return 0;
  return seed.true_inv_distance * truth.scale;
}

bool drawable(const BeliefView& b) {
  return std::isfinite(b.mu) && std::isfinite(b.sigma) && b.sigma > 0;
}

const BeliefView& firstComputed(const ByRule<BeliefView>& beliefs) {
  for (const FilterRule rule : kRules) {
    if (drawable(beliefs[rule])) return beliefs[rule];
  }
  return beliefs[kRules.back()];
}

double inlierRatio(const BeliefView& b) {
  const double n = static_cast<double>(b.a) + b.b;
  return b.a >= 0 && b.b >= 0 && n > 0 && std::isfinite(n) ? b.a / n : NAN;
}

}  // namespace svoscope::ui
