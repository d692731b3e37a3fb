// SPDX-License-Identifier: MIT
// One method per command; internal to the harness.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "ui/harness/executor.h"
#include "ui/harness/gestures.h"

namespace svoscope::ui {

std::string joined(const std::vector<std::string>& words);
Result<double> toNumber(const std::string& text);
/// The first word as a count or frame number; `otherwise` if there is none.
Result<int> toCount(const std::vector<std::string>& words, int otherwise);

class Executor {
 public:
  explicit Executor(const ScriptStage& stage)
      : stage_(stage), gestures_(stage.host, stage.content, stage.runner) {}

  Status run(const ScriptCommand& command);
  ScriptReport report;

 private:
  using Words = std::vector<std::string>;
  using Action = Status (Executor::*)(const ScriptCommand&);
  static const std::map<std::string, Action>& actions();

  Status open(const ScriptCommand&) { return Done{}; }  // done by whoever made the runner
  Status step(const ScriptCommand& c);
  Status runTo(const ScriptCommand& c);
  Status reset(const ScriptCommand&);
  Status back(const ScriptCommand& c);
  Status gotoFrame(const ScriptCommand& c);
  Status select(const ScriptCommand& c);
  Status selectOne(const Words& words, const ScriptCommand& c);
  Status showRun(const ScriptCommand& c);
  Status panel(const ScriptCommand& c) { return stage_.target.showPanel(joined(c.arguments)); }
  Status layout(const ScriptCommand& c) { return stage_.target.setLayout(joined(c.arguments)); }
  Status click(const ScriptCommand& c) { return clickWidget(c, 0, 1); }
  Status doubleClick(const ScriptCommand& c) { return clickWidget(c, 0, 2); }
  Status rightClick(const ScriptCommand& c) { return clickWidget(c, 1, 1); }
  Status hover(const ScriptCommand& c);
  Status drag(const ScriptCommand& c);
  Status wheel(const ScriptCommand& c);
  Status key(const ScriptCommand& c);
  Status type(const ScriptCommand& c);
  Status wait(const ScriptCommand& c);
  Status set(const ScriptCommand& c);
  Status scale(const ScriptCommand& c);
  Status size(const ScriptCommand& c);
  Status shot(const ScriptCommand& c);
  Status exportPanel(const ScriptCommand& c);
  Status expect(const ScriptCommand& c);

  Status clickWidget(const ScriptCommand& c, int button, int times);
  Status picture(const std::filesystem::path& file, const std::string& panel);
  Status needRunner() const;
  int shownFrame() const;
  std::optional<ScriptValue> value(const std::string& name) const;

  const ScriptStage& stage_;
  Gestures gestures_;
};

}  // namespace svoscope::ui
