// SPDX-License-Identifier: MIT
// What scripts may ask of the inspector, by its UiState.
#pragma once

#include "engine/runner/runner.h"
#include "ui/harness/script_target.h"
#include "ui/ui_state.h"

namespace svoscope::ui {

class InspectorTarget : public ScriptTarget {
 public:
  InspectorTarget(Runner& runner, UiState& state) : runner_(runner), state_(state) {}

  int shownFrame() const override { return state_.viewed_frame; }
  Status showFrame(int index) override;
  Status selectFeature(std::int64_t id) override;
  Status selectSeed(std::int64_t id) override;
  Status selectNothing() override;
  std::optional<ImVec2> screenPosition(float x, float y) const override;
  Status showPanel(const std::string& name) override;
  Status setLayout(const std::string& name) override;
  Status set(const std::string& key, const std::string& value) override;
  std::optional<ScriptValue> value(const std::string& name) const override;

 private:
  SnapshotPtr shown() const;

  Runner& runner_;
  UiState& state_;
};

}  // namespace svoscope::ui
