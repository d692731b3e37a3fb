// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "engine/base/result.h"
#include "engine/study/depth_study.h"

namespace svoscope {

/// Writes depth_study.csv (one row per rule), depth_study.json and depth_study.png into `folder`,
/// made if absent. Figures that do not exist are empty or null. Output error naming the file.
Status writeDepthStudy(const std::filesystem::path& folder, const DepthStudyResult& result);

/// The rows as a table for a terminal.
std::string depthStudyText(const DepthStudyResult& result);

}  // namespace svoscope
