// SPDX-License-Identifier: MIT
#include "ui/model/selection_history.h"

#include <algorithm>
#include <cmath>

namespace svoscope::ui {

namespace {

Selection::Kind kindOf(FeatureOrigin origin) {
  switch (origin) {
    case FeatureOrigin::landmark:
      return Selection::Kind::landmark;
    case FeatureOrigin::track:
      return Selection::Kind::track;
    default:
      return Selection::Kind::seed;
  }
}

}  // namespace

Selection selectionOf(const FeatureView& feature) { return {kindOf(feature.origin), feature.id}; }

const FeatureView* findFeature(const Snapshot& snapshot, const Selection& selection) {
  for (const FeatureView& f : snapshot.features) {
    if (f.id == selection.id && kindOf(f.origin) == selection.kind) return &f;
  }
  return nullptr;
}

const SeedView* findSeed(const Snapshot& snapshot, std::int64_t id) {
  if (!snapshot.seeds) return nullptr;
  for (const SeedView& s : *snapshot.seeds) {
    if (s.id == id) return &s;
  }
  return nullptr;
}

const MapPointView* findPoint(const Snapshot& snapshot, std::int64_t id) {
  if (!snapshot.points) return nullptr;
  for (const MapPointView& p : *snapshot.points) {
    if (p.id == id) return &p;
  }
  return nullptr;
}

void SelectionHistory::update(const RunView& run, const Selection& selection,
                              const SnapshotPtr& latest) {
  const int generation = run.generation();
  if (selection != selection_ || generation != generation_) {
    *this = SelectionHistory();
    selection_ = selection;
    generation_ = generation;
  }
  if (!selection_ || !latest) return;
  next_ = std::max(next_, run.status().history_first);
  for (; next_ <= latest->record.index; ++next_) {
    if (const SnapshotPtr s = run.valuesAt(next_)) add(*s);
  }
}

void SelectionHistory::add(const Snapshot& snapshot) {
  const auto frame = static_cast<float>(snapshot.record.index);
  if (const FeatureView* f = findFeature(snapshot, selection_)) {
    frames.push_back(frame);
    residual.push_back(f->status == FeatureStatus::not_aligned ? NAN : f->residual_px);
    depth.push_back(f->depth);
    observations.push_back(static_cast<float>(f->observations));
    last_seen = snapshot.record.index;
  }
  if (selection_.kind != Selection::Kind::seed) return;
  if (const SeedView* s = findSeed(snapshot, selection_.id)) {
    seed_frames.push_back(frame);
    mu.push_back(s->mu);
    mu_lo.push_back(s->mu - s->sigma);
    mu_hi.push_back(s->mu + s->sigma);
    sigma_ratio.push_back(s->range > 0 ? s->sigma / s->range : NAN);
    inlier_ratio.push_back(s->a + s->b > 0 ? s->a / (s->a + s->b) : NAN);
    last_seen = snapshot.record.index;
    last_seed = *s;
  }
}

}  // namespace svoscope::ui
