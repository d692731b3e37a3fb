// SPDX-License-Identifier: MIT
// What a script may ask of the thing on screen beyond clicks and keys. The inspector's adapter
// implements it; tests have small ones.
#pragma once

#include <imgui/imgui.h>

#include <cstdint>
#include <optional>
#include <string>

#include "engine/base/result.h"
#include "ui/harness/expectation.h"

namespace svoscope {
class RunView;
}

namespace svoscope::ui {

class ScriptTarget {
 public:
  virtual ~ScriptTarget() = default;
  /// Frame in view; -1 if none. `showFrame(-1)` follows the engine.
  virtual int shownFrame() const { return -1; }
  virtual Status showFrame(int index) { return refuse("frame " + std::to_string(index)); }
  /// Negative: any, chosen the same way every time.
  virtual Status selectFeature(std::int64_t id) { return refuse("feature " + std::to_string(id)); }
  virtual Status selectSeed(std::int64_t id) { return refuse("seed " + std::to_string(id)); }
  virtual Status selectNothing() { return Done{}; }
  /// Place on screen of a pixel of the image, for a real click on it.
  virtual std::optional<ImVec2> screenPosition(float x, float y) const {
    (void)x, (void)y;
    return std::nullopt;
  }
  virtual Status showPanel(const std::string& name) { return refuse("panel " + name); }
  /// Why a panel is not on screen; done if it is, or nothing is known of it.
  virtual Status panelOnScreen(const std::string& name) const {
    (void)name;
    return Done{};
  }
  virtual Status setLayout(const std::string& name) { return refuse("layout " + name); }
  /// Asks for the panel's numbers or charts in `file`, .csv or .svg; done in the next frame.
  virtual Status requestExport(const std::string& panel, const std::string&) {
    return refuse("panel " + panel);
  }
  /// What came of it.
  virtual Status exportResult() const { return Done{}; }
  virtual Status showRun(const std::string& name) { return refuse("run " + name); }
  /// An open run by name or number, for `expect NAME@RUN`; null if there is none.
  virtual const RunView* findRun(const std::string& name) const {
    (void)name;
    return nullptr;
  }
  virtual Status set(const std::string& key, const std::string&) { return refuse("option " + key); }
  /// Values for `expect` that the engine does not know: "selected.id", "panel", ...
  virtual std::optional<ScriptValue> value(const std::string& name) const {
    (void)name;
    return std::nullopt;
  }

 private:
  static Status refuse(const std::string& what) {
    return usageError(what + " is not known here", "", "");
  }
};

}  // namespace svoscope::ui
