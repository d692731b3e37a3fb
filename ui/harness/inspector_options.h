// SPDX-License-Identifier: MIT
// The inspector's display options by name, for `set` and `expect`: "image.trails", "scene.follow".
#pragma once

#include <optional>
#include <string>

#include "engine/base/result.h"
#include "ui/harness/expectation.h"
#include "ui/model/ui_state.h"

namespace svoscope::ui {

Status setOption(UiState& state, const std::string& name, const std::string& value);
std::optional<ScriptValue> optionValue(const UiState& state, const std::string& name);

}  // namespace svoscope::ui
