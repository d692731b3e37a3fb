// SPDX-License-Identifier: MIT
// Text of exported files.
#pragma once

#include <string>
#include <vector>

#include "ui/model/run_cache.h"

namespace svoscope::ui {

/// TUM format: timestamp tx ty tz qx qy qz qw, frames with a good pose.
std::string trajectoryText(const std::vector<FrameRecord>& records);
/// One row per frame with every series that can be plotted and every stage's time.
std::string framesCsv(const RunCache& run);

}  // namespace svoscope::ui
