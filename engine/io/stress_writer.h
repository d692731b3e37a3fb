// SPDX-License-Identifier: MIT
// The robustness suite as CSV and as Markdown tables.
#pragma once

#include <string>
#include <vector>

#include "engine/study/stress.h"

namespace svoscope {

const char* stressCsvHeader();
std::string stressCsvRow(const StressRow& row);

/// "Where does each method break": one row per stress and column per method, then a table per
/// stress. `stresses` gives order and meaning; those without rows are left out, a method that is
/// not there for a level (stopped early) is an empty cell.
std::string stressMarkdown(const std::vector<Stress>& stresses, const std::vector<StressRow>& rows);

/// The first of these tables for a terminal.
std::string stressText(const std::vector<Stress>& stresses, const std::vector<StressRow>& rows);

}  // namespace svoscope
