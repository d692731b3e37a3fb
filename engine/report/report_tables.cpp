// SPDX-License-Identifier: MIT
#include "engine/report/report_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace svoscope {

namespace {

using CellsOf = std::function<std::vector<ReportCell>(std::size_t)>;

std::size_t ownOf(const BenchResults& results) { return static_cast<std::size_t>(results.own); }

/// Rows under a heading for each group of sequences, if there is more than one.
void addSequenceRows(const BenchResults& results, ReportTable& table, const CellsOf& cells) {
  std::vector<std::string> groups;
  for (const BenchSequence& s : results.config.sequences) {
    if (std::find(groups.begin(), groups.end(), s.group) == groups.end()) groups.push_back(s.group);
  }
  for (const std::string& group : groups) {
    if (groups.size() > 1) table.rows.push_back({true, {{group}}});
    for (std::size_t s = 0; s < results.config.sequences.size(); ++s) {
      if (results.config.sequences[s].group != group) continue;
      ReportRow row{false, {{results.config.sequences[s].name}}};
      for (ReportCell& cell : cells(s)) row.cells.push_back(std::move(cell));
      table.rows.push_back(std::move(row));
    }
  }
}

/// The system with the least (or, if more is better, largest) mean; none if fewer than two have
/// one.
std::optional<std::size_t> bestOf(const BenchResults& results, std::size_t s,
                                  const FigureInfo& info) {
  std::optional<std::size_t> best;
  double best_mean = 0;
  int found = 0;
  for (std::size_t m = 0; m < ownOf(results); ++m) {
    const auto spread = results.spread(s, m, info);
    if (!spread) continue;
    ++found;
    if (best && !(info.less_is_better ? spread->mean < best_mean : spread->mean > best_mean))
      continue;
    best = m;
    best_mean = spread->mean;
  }
  return found > 1 ? best : std::nullopt;
}

ReportCell figureCell(const BenchResults& results, std::size_t s, std::size_t m,
                      const FigureInfo& info, bool mark) {
  const int runs = static_cast<int>(results.runs[s][m].size());
  return {spreadText(results.spread(s, m, info), info.digits, runs),
          mark && bestOf(results, s, info) == m};
}

std::string withUnit(const FigureInfo& info) {
  return *info.unit ? fmt::format("{}, {}", info.label, info.unit) : info.label;
}

std::string intervalOf(double ratio, const Interval& interval) {
  return fmt::format("{:.2f} [{:.2f}, {:.2f}]", ratio, interval.low, interval.high);
}

std::string pairName(const BenchResults& results, const Comparison& c) {
  return results.systems[c.a].system.label + " / " + results.systems[c.b].system.label;
}

}  // namespace

std::string spreadText(const std::optional<Spread>& spread, int digits, int runs) {
  if (!spread) return "-";
  // Errors of millimetres need a digit more, counts that are whole none.
  if (digits >= 4 && std::abs(spread->mean) < 0.01) ++digits;
  if (digits == 1 && spread->low == spread->high && spread->mean == std::floor(spread->mean))
    digits = 0;
  std::string text = fmt::format("{:.{}f}", spread->mean, digits);
  if (spread->high > spread->low)
    text += fmt::format(" ± {:.{}f}", spread->stddev, std::max(digits, 1));
  if (spread->count < runs) text += fmt::format(" ({}/{})", spread->count, runs);
  return text;
}

ReportTable errorTable(const BenchResults& results) {
  ReportTable table;
  table.id = "errors";
  table.title = "Errors by sequence";
  table.note =
      "RPE translation (m), RPE rotation (rad) and ATE (m), root mean squares; mean ± standard "
      "deviation over "
      "the runs that count; - failed.";
  table.groups = {{"", 1}};
  table.header = {"Sequence"};
  for (std::size_t m = 0; m < ownOf(results); ++m) {
    table.groups.emplace_back(results.systems[m].system.label, 3);
    table.header.insert(table.header.end(), {"Trans", "Rot", "ATE"});
  }
  addSequenceRows(results, table, [&](std::size_t s) {
    std::vector<ReportCell> cells;
    for (std::size_t m = 0; m < ownOf(results); ++m) {
      for (const char* key : {"rpe_trans_m", "rpe_rot_rad", "ate_m"})
        cells.push_back(figureCell(results, s, m, figure(key), true));
    }
    return cells;
  });
  return table;
}

ReportTable peerTable(const BenchResults& results) {
  ReportTable table;
  table.id = "peers";
  table.title = "ATE and frames tracked beside other systems";
  table.note =
      "ATE rmse in m over the frames tracked, and the fraction of frames with a pose since the "
      "first one; both "
      "are to be read together.";
  table.header = {"Sequence"};
  for (const ResultSystem& system : results.systems) table.header.push_back(system.system.label);
  addSequenceRows(results, table, [&](std::size_t s) {
    std::vector<ReportCell> cells;
    for (std::size_t m = 0; m < results.systems.size(); ++m) {
      const auto ate = results.spread(s, m, figure("ate_m")),
                 tracked = results.spread(s, m, figure("tracked"));
      const std::string mean =
          ate ? fmt::format("{:.{}f}", ate->mean, ate->mean < 0.01 ? 5 : 4) : "-";
      cells.push_back({tracked ? fmt::format("{} @ {:.0f} %", mean, 100 * tracked->mean) : mean});
    }
    return cells;
  });
  return table;
}

ReportTable figureTableOf(const BenchResults& results, const std::string& key,
                          const std::string& note) {
  const FigureInfo& info = figure(key);
  ReportTable table;
  table.id = key;
  table.title = withUnit(info);
  table.note = note;
  table.header = {"Sequence"};
  for (std::size_t m = 0; m < ownOf(results); ++m)
    table.header.push_back(results.systems[m].system.label);
  addSequenceRows(results, table, [&](std::size_t s) {
    std::vector<ReportCell> cells;
    for (std::size_t m = 0; m < ownOf(results); ++m)
      cells.push_back(figureCell(results, s, m, info, false));
    return cells;
  });
  return table;
}

ReportTable comparisonTable(const BenchResults& results,
                            const std::vector<Comparison>& comparisons) {
  ReportTable table;
  table.id = "comparison";
  table.title = "Methods compared over all sequences";
  table.note = fmt::format(
      "Geometric mean over sequences of A's figure / B's, with a 95 % bootstrap interval over "
      "sequences and runs; below 1, A "
      "is lower, which is better. Decided only from {} sequences on. Intervals are not corrected "
      "for the number of "
      "comparisons.",
      kLeastSequences);
  table.header = {"A / B",    "Figure",    "Sequences", "Ratio", "Verdict for A",
                  "Lower on", "Higher on", "Only A",    "Only B"};
  table.text_columns = 2;
  for (const Comparison& c : comparisons) {
    int lower = 0, higher = 0;
    for (const SequenceComparison& s : c.sequences) (s.ratio < 1 ? lower : higher) += s.ratio != 1;
    const char* verdicts[] = {"better", "worse", "undecided"};
    table.rows.push_back({false,
                          {{pairName(results, c)},
                           {withUnit(*c.figure)},
                           {std::to_string(c.sequences.size())},
                           {c.sequences.empty() ? "-" : intervalOf(c.ratio, c.ratios)},
                           {verdicts[static_cast<int>(c.verdict)], c.verdict != Verdict::undecided},
                           {std::to_string(lower)},
                           {std::to_string(higher)},
                           {std::to_string(c.only_a.size())},
                           {std::to_string(c.only_b.size())}}});
  }
  return table;
}

ReportTable ratioTable(const BenchResults& results, const std::vector<Comparison>& comparisons) {
  ReportTable table;
  table.id = "ratios";
  table.title = "Ratio of ATE by sequence";
  table.note =
      "A's ATE / B's with a 95 % bootstrap interval over the runs; bold where every run of the one "
      "lies below every "
      "run of the other; - where not both complete.";
  table.header = {"Sequence"};
  std::vector<const Comparison*> shown;
  for (const Comparison& c : comparisons) {
    if (c.figure->value != &RunFigures::ate_m) continue;
    shown.push_back(&c);
    table.header.push_back(pairName(results, c));
  }
  addSequenceRows(results, table, [&](std::size_t s) {
    std::vector<ReportCell> cells;
    for (const Comparison* c : shown) {
      ReportCell cell{"-"};
      for (const SequenceComparison& row : c->sequences) {
        if (row.sequence == s)
          cell = {intervalOf(row.ratio, row.ratios), row.verdict != Verdict::undecided};
      }
      cells.push_back(cell);
    }
    return cells;
  });
  return table;
}

ReportTable failureTable(const BenchResults& results) {
  ReportTable table;
  table.id = "failures";
  table.title = "Runs that do not count";
  table.header = {"Sequence", "System", "Reason", "Runs"};
  table.text_columns = 3;
  for (std::size_t s = 0; s < results.config.sequences.size(); ++s) {
    for (std::size_t m = 0; m < results.systems.size(); ++m) {
      std::map<std::string, int> reasons;
      for (const RunResult& run : results.runs[s][m]) {
        const bool absent_peer = results.systems[m].peer && !run.present;
        if (!run.good && !absent_peer) ++reasons[run.why];
      }
      for (const auto& [reason, count] : reasons) {
        const bool right = results.config.sequences[s].still && reason == "never initialised";
        table.rows.push_back({false,
                              {{results.config.sequences[s].name},
                               {results.systems[m].system.label},
                               {right ? reason + " (right: the camera stands still)" : reason},
                               {fmt::format("{} of {}", count, results.runs[s][m].size())}}});
      }
    }
  }
  return table;
}

}  // namespace svoscope
