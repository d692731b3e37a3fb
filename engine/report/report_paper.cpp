// SPDX-License-Identifier: MIT
// The paper's tables with our figures below where the sequence is the same.
#include <fmt/format.h>

#include "engine/report/paper_figures.h"
#include "engine/report/report_tables.h"

namespace svoscope {

namespace {

bool hasErrors(int table) { return table != 2 && table != 4 && table != 5; }

/// Our sequence for a row of the paper.
std::optional<std::size_t> oursFor(const BenchResults& results, const PaperRow& row) {
  for (std::size_t s = 0; s < results.config.sequences.size(); ++s) {
    if (samePaperSequence(row.sequence, results.config.sequences[s].name)) return s;
  }
  return std::nullopt;
}

/// Our column for a method of the paper: its first variant.
std::optional<std::size_t> columnOf(const BenchResults& results, const std::string& method) {
  for (std::size_t m = 0; m < static_cast<std::size_t>(results.own); ++m) {
    if (results.systems[m].system.method == method) return m;
  }
  return std::nullopt;
}

void addPaperCells(const PaperRow& row, ReportRow& out) {
  for (std::size_t m = 0; m < 3; ++m) {
    if (!hasErrors(row.table)) {
      out.cells.push_back({row.value[m] ? fmt::format("{:g}", *row.value[m]) : "-"});
      continue;
    }
    const auto& e = row.errors[m];
    out.cells.push_back({e ? fmt::format("{:.4f}", e->rpe_trans_m) : "-"});
    out.cells.push_back({e ? fmt::format("{:.4f}", e->rpe_rot_rad) : "-"});
    out.cells.push_back({e ? fmt::format("{:g}", e->ate_m) : "-"});
  }
}

void addOurCells(const BenchResults& results, const PaperRow& row,
                 std::optional<std::size_t> sequence, ReportRow& out) {
  const std::vector<std::string> keys =
      hasErrors(row.table)
          ? std::vector<std::string>{"rpe_trans_m", "rpe_rot_rad", "ate_m"}
          : std::vector<std::string>{row.table == 5 ? "fps" : "relocalisation_time_s"};
  for (const std::string& method : paperMethods()) {
    const auto column = columnOf(results, method);
    for (const std::string& key : keys) {
      const FigureInfo& info = figure(key);
      const bool ran = sequence && column;
      out.cells.push_back(
          {ran ? spreadText(results.spread(*sequence, *column, info), info.digits,
                            static_cast<int>(results.runs[*sequence][*column].size()))
               : "not run"});
    }
  }
}

ReportTable paperTable(const BenchResults& results, int number) {
  ReportTable table;
  table.id = fmt::format("paper-{}", number);
  table.title = fmt::format("Table {}: {}", number, paperTableTitle(number));
  table.text_columns = 2;
  table.header = {"Sequence", "From"};
  if (hasErrors(number)) table.groups = {{"", 2}};
  for (const char* name : {"SVO", "PL-SVO", "IT-SVO"}) {
    if (hasErrors(number)) {
      table.groups.emplace_back(name, 3);
      table.header.insert(table.header.end(), {"Trans", "Rot", "ATE"});
    } else {
      table.header.push_back(name);
    }
  }
  for (const PaperRow& row : paperRows()) {
    if (row.table != number) continue;
    ReportRow paper{false, {{row.sequence}, {"paper"}}}, ours{false, {{""}, {"here"}}};
    addPaperCells(row, paper);
    addOurCells(results, row, oursFor(results, row), ours);
    table.rows.push_back(std::move(paper));
    table.rows.push_back(std::move(ours));
  }
  return table;
}

}  // namespace

std::vector<ReportTable> paperTables(const BenchResults& results) {
  std::vector<ReportTable> tables;
  for (int number = 1; number <= 7; ++number) tables.push_back(paperTable(results, number));
  return tables;
}

}  // namespace svoscope
