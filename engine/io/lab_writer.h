// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "engine/base/result.h"
#include "engine/eval/lab.h"

namespace svoscope {

/// Writes lab.csv (one row per rule), curves.csv (one row per rule and update) and lab.png into
/// `folder`, made if absent. Output error naming the file.
Status writeLab(const std::filesystem::path& folder, const LabResult& result);

/// The rows as a table for a terminal.
std::string labText(const LabResult& result);

}  // namespace svoscope
