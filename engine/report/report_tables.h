// SPDX-License-Identifier: MIT
// The tables of a benchmark's report. "-" stands for failed, as in the paper.
#pragma once

#include <vector>

#include "engine/report/bench_results.h"
#include "engine/report/comparison.h"
#include "engine/report/report_table.h"

namespace svoscope {

/// RPE translation, RPE rotation and ATE of each of our systems (form of the paper's tables 1, 3,
/// 6, 7).
ReportTable errorTable(const BenchResults& results);
/// ATE and tracked fraction beside external systems.
ReportTable peerTable(const BenchResults& results);
/// One figure, a column for each of our systems ("keyframes", "init_time_s", "fps" ...; forms of
/// the paper's tables 2, 4, 5).
ReportTable figureTableOf(const BenchResults& results, const std::string& key,
                          const std::string& note);
/// Ratio, interval and verdict of each pair of systems over all sequences.
ReportTable comparisonTable(const BenchResults& results,
                            const std::vector<Comparison>& comparisons);
/// Ratio of ATE of each pair on each sequence.
ReportTable ratioTable(const BenchResults& results, const std::vector<Comparison>& comparisons);
/// Runs that do not count, with the reason.
ReportTable failureTable(const BenchResults& results);
/// The paper's tables 1 to 7 with our figures below where the sequence is the same.
std::vector<ReportTable> paperTables(const BenchResults& results);

/// "0.0440 ± 0.0021 (2/3)": mean, spread, and of how many runs if not of all; "-" without a value.
std::string spreadText(const std::optional<Spread>& spread, int digits, int runs);

}  // namespace svoscope
