// SPDX-License-Identifier: MIT
// A panel of the depth filter shown alone, with a seed selected.
#pragma once

#include "tests/ui/inspector/inspector_fixture.h"

namespace svoscope::ui {

inline const SeedUpdateView& anUpdate(const Snapshot& s) {
  for (const SeedUpdateView& u : *s.seed_updates) {
    const SeedView* seed = findSeed(s, u.seed_id);
    if (seed && seed->visible && seed->updates > 20) return u;
  }
  return s.seed_updates->front();
}

class SeedPanels : public InspectorTest {
 protected:
  void openAt(int frame, const char* panel) {
    open({}, 1280, 900);
    runner_->runTo(frame);
    update_ = anUpdate(*runner_->latest());
    state().selection = {Selection::Kind::seed, update_.seed_id};
    maximize(panel);
    frames(4);
  }
  void maximize(const char* panel) {
    if (!hasPanel(state().layout.root, panel)) showPanel(state().layout.root, panel);
    raisePanel(state().layout.root, panel);
    state().maximized = panel;
  }
  SeedUpdateView update_;
};

}  // namespace svoscope::ui
