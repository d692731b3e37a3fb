// SPDX-License-Identifier: MIT
// The runs that are open, one or several in lockstep, and how each of them looks everywhere.
#pragma once

#include <imgui/imgui.h>

#include <optional>
#include <string>
#include <vector>

#include "engine/base/look.h"
#include "engine/runner/lockstep_runner.h"

namespace svoscope::ui {

struct RunStyle {
  std::string label;  ///< as shown: "PL-SVO", "orb"
  std::string name;   ///< in scripts and files: "pl-svo", "orb"
  ImU32 color = 0;
  Dash dash = Dash::solid;
  bool poses_only = false;
};

class Runs {
 public:
  /// `runner` may be a LockstepRunner; any other is the only run.
  explicit Runs(Runner& runner);

  int size() const { return static_cast<int>(styles_.size()); }
  int current() const { return lockstep_ ? lockstep_->current() : 0; }
  const RunView& run(int i) const { return lockstep_ ? lockstep_->run(i) : *runner_; }
  const RunStyle& style(int i) const { return styles_[static_cast<std::size_t>(i)]; }
  Status setCurrent(int i);
  /// By name or label, or by number from 0; nothing if there is none.
  std::optional<int> find(const std::string& name) const;
  /// The next run that can become the current one; `by` +1 or -1.
  int neighbour(int by) const;
  /// Last frame that all have; -1 before the first.
  int frame() const;

 private:
  Runner* runner_;
  LockstepRunner* lockstep_;
  std::vector<RunStyle> styles_;
};

}  // namespace svoscope::ui
