// SPDX-License-Identifier: MIT
// The depth study that `svoscope run --depth-study` adds to a run.
#pragma once

#include <string>
#include <vector>

#include "app/run_settings.h"
#include "engine/snapshot/frame_record.h"

namespace svoscope {

/// Input error, before any work is done, if the sequence cannot be studied.
Status checkDepthStudy(const RunSettings& run);

/// Studies the sequence of `run` with poses from "groundtruth" or "estimate" (the `records` of a
/// finished run, aligned), and writes the result into `out`. Returns the exit code.
int runDepthStudyCommand(const RunSettings& run, const std::string& poses_from,
                         const std::string& out, const std::vector<FrameRecord>& records);

}  // namespace svoscope
