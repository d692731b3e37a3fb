// SPDX-License-Identifier: MIT
// What scripts may ask of the inspector, by its UiState.
#pragma once

#include "engine/runner/runner.h"
#include "ui/harness/script_target.h"
#include "ui/model/runs.h"
#include "ui/model/ui_state.h"

namespace svoscope::ui {

class InspectorTarget : public ScriptTarget {
 public:
  InspectorTarget(Runner& runner, UiState& state) : runner_(runner), runs_(runner), state_(state) {}

  int shownFrame() const override {
    // The newest snapshot of the current run may be older than the frame all runs are at.
    return state_.viewed_frame < 0 && runs_.size() > 1 ? runs_.frame() : state_.viewed_frame;
  }
  Status showFrame(int index) override;
  Status selectFeature(std::int64_t id) override;
  Status selectSeed(std::int64_t id) override;
  Status selectNothing() override;
  std::optional<ImVec2> screenPosition(float x, float y) const override;
  Status showPanel(const std::string& name) override;
  Status panelOnScreen(const std::string& name) const override;
  Status setLayout(const std::string& name) override;
  Status requestExport(const std::string& panel, const std::string& file) override;
  Status exportResult() const override;
  Status showRun(const std::string& name) override;
  const RunView* findRun(const std::string& name) const override;
  Status set(const std::string& key, const std::string& value) override;
  std::optional<ScriptValue> value(const std::string& name) const override;

 private:
  SnapshotPtr shown() const;

  Runner& runner_;
  Runs runs_;
  UiState& state_;
};

}  // namespace svoscope::ui
