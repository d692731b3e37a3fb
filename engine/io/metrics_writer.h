// SPDX-License-Identifier: MIT
// The figures of a run as metrics.json (docs/commands.md) and as text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "engine/eval/run_metrics.h"

namespace svoscope {

/// The objects `ate` and `rpe` of metrics.json and of `eval --json`; null without a result.
nlohmann::ordered_json ateJson(const std::optional<EvalResult>& evaluation);
nlohmann::ordered_json rpeJson(const std::optional<EvalResult>& evaluation);

nlohmann::ordered_json metricsJson(const RunMetrics& metrics);

/// A few lines for people.
std::string metricsText(const RunMetrics& metrics);

}  // namespace svoscope
