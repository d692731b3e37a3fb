// SPDX-License-Identifier: MIT
// `expect inliers >= 50`: comparison of a named value with a constant.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/base/result.h"

namespace svoscope::ui {

/// Truth values are the numbers 1 and 0, written true and false.
using ScriptValue = std::variant<double, std::string, std::vector<std::string>>;
using ScriptValues = std::function<std::optional<ScriptValue>(const std::string& name)>;

/// "12", "tracking", "[Play, Step]".
std::string describe(const ScriptValue& value);

/// Done if it holds; otherwise `what` of the error gives the actual value. `words` are the
/// expression's words with quotes removed: name, operator, value.
Status checkExpectation(const std::vector<std::string>& words, const ScriptValues& values);

}  // namespace svoscope::ui
