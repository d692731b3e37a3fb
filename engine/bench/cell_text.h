// SPDX-License-Identifier: MIT
// What is said of a cell: why it failed, or what came out.
#pragma once

#include <filesystem>
#include <string>

#include "engine/bench/cell_record.h"

namespace svoscope {

/// The last error of the program in its log, without what helps; empty if there is none.
std::string lastError(const std::filesystem::path& log);

/// Why a cell is no result, from its end and its log; empty if it is one.
std::string reasonOf(const CellRecord& record, const std::filesystem::path& folder,
                     double timeout_s);

/// "ATE 0.0440 m, 100 % tracked", from metrics.json.
std::string headline(const std::filesystem::path& folder);

}  // namespace svoscope
