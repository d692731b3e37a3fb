// SPDX-License-Identifier: MIT
// The report of a benchmark: report.md, report.html, tables.tex, results.csv.
#pragma once

#include <filesystem>
#include <string>

#include "engine/report/bench_results.h"
#include "engine/report/comparison.h"
#include "engine/report/report_table.h"

namespace svoscope {

/// Everything the formats share.
struct Report {
  std::string title;
  std::vector<std::string> facts;  ///< a line each: how much was run, where, how it was judged
  /// A pair of systems with what is to be said about it.
  std::vector<std::pair<std::string, std::vector<std::string>>> findings;
  std::vector<ReportTable> tables;        ///< in the order of the text
  std::vector<ReportTable> paper_tables;  ///< tables 1 to 7
  std::vector<Comparison> comparisons;
};

Report makeReport(const BenchResults& results);

std::string reportMarkdown(const Report& report);
/// Tables for a LaTeX document with the package booktabs.
std::string reportLatex(const Report& report);
/// One page with style and figures inside.
std::string reportHtml(const BenchResults& results, const Report& report);
/// One row per cell of our systems, whether it counts or not.
std::string resultsCsv(const BenchResults& results);
/// The same columns for external trajectories.
std::string peersCsv(const BenchResults& results);

/// Reads DIR and writes the files into it. Input and output errors name the file.
Status writeReport(const std::filesystem::path& dir);

}  // namespace svoscope
