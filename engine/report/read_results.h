// SPDX-License-Identifier: MIT
// Results as they lie in the folder of a benchmark, with errors computed anew from trajectories.
#pragma once

#include <filesystem>

#include "engine/base/result.h"
#include "engine/report/bench_results.h"

namespace svoscope {

/// Reads DIR. Cells that are missing or of another plan are "not run". Input error if there is no
/// bench.yaml.
Result<BenchResults> readBenchResults(const std::filesystem::path& dir);

}  // namespace svoscope
