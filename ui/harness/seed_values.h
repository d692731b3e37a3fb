// SPDX-License-Identifier: MIT
// What `expect` may ask about the selected seed and the seed panels.
#pragma once

#include <optional>
#include <string>

#include "engine/snapshot/snapshot.h"
#include "ui/harness/expectation.h"
#include "ui/model/ui_state.h"

namespace svoscope::ui {

/// "seed.mu", "seed.kl.sigma", "seed.js.ratio", "seed.updates", "seed.status", ...: of the selected
/// seed in `snapshot`; "seed.update" and "seed.held": update looked at (from 1) and updates held;
/// "highlighted" and "pinned": how many seeds.
std::optional<ScriptValue> seedValue(const Snapshot* snapshot, const UiState& state,
                                     const std::string& name);

}  // namespace svoscope::ui
