// SPDX-License-Identifier: MIT
// Text of exported files.
#pragma once

#include <string>
#include <vector>

#include "ui/model/run_cache.h"

namespace svoscope::ui {

/// TUM format: timestamp tx ty tz qx qy qz qw, frames with a good pose.
std::string trajectoryText(const std::vector<FrameRecord>& records);
/// The frames.csv of a run: every field of every frame.
std::string framesCsv(const RunCache& run);

}  // namespace svoscope::ui
