// SPDX-License-Identifier: MIT
// frames.csv: everything that is known of a frame, one row each (docs/commands.md).
#pragma once

#include <string>

#include "engine/snapshot/frame_record.h"

namespace svoscope {

/// Names of the columns, separated by commas.
std::string framesCsvHeader();
/// The row of a frame. Pose columns are empty without a good pose; texts are quoted.
std::string framesCsvRow(const FrameRecord& record);

}  // namespace svoscope
