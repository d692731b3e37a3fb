// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "engine/eval/run_metrics.h"

namespace svoscope {

/// One line per run with the figures that tell methods apart; "-" where a figure is not defined.
std::string methodTable(const std::vector<RunMetrics>& runs);

}  // namespace svoscope
