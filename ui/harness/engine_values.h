// SPDX-License-Identifier: MIT
// What `expect` can ask of the run: "state", "inliers", "keyframes", ...
#pragma once

#include <optional>
#include <string>

#include "engine/runner/run_view.h"
#include "ui/harness/expectation.h"

namespace svoscope::ui {

/// `frame` is the one in view; its row of the table answers, so evicted frames do, too.
std::optional<ScriptValue> engineValue(const RunView& run, int frame, const std::string& name);
std::string engineValueNames();

}  // namespace svoscope::ui
