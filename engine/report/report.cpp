// SPDX-License-Identifier: MIT
#include "engine/report/report.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/io/csv.h"
#include "engine/io/text_output.h"
#include "engine/report/paper_figures.h"
#include "engine/report/read_results.h"
#include "engine/report/report_tables.h"

namespace svoscope {

namespace fs = std::filesystem;

namespace {

std::string listed(const std::vector<std::string>& items) {
  std::string text;
  for (const std::string& item : items) text += (text.empty() ? "" : "; ") + item;
  return text;
}

std::vector<std::string> factsOf(const BenchResults& results) {
  const BenchConfig& c = results.config;
  std::vector<std::string> facts;
  const std::size_t cells = cellsOf(c).size();
  facts.push_back(fmt::format(
      "{} sequences, {} systems, {}: {} runs{}.", c.sequences.size(), results.own,
      c.sync ? std::string("one synchronous run each")
             : fmt::format("{} threaded run{} each", c.runs, c.runs == 1 ? "" : "s"),
      cells, results.missing > 0 ? fmt::format(", {} of them not done", results.missing) : ""));
  const EvalOptions& e = c.evaluation;
  facts.push_back(fmt::format(
      "Errors: alignment {} on {}, association within {} s, RPE over {}, {} pairs.",
      alignmentName(e.alignment),
      e.align_first > 0 ? fmt::format("the first {} poses", e.align_first) : "all poses", e.max_dt,
      e.delta.text(), e.all_pairs ? "all" : "consecutive"));
  facts.push_back(fmt::format(
      "A run counts if it started and tracked at least {:.0f} % of the frames since; others are "
      "failed and stand in the last "
      "table. Figures are means over the runs that count, with their standard deviation.",
      100 * c.least_tracked));
  if (!results.machines.empty())
    facts.push_back(fmt::format("Processor: {}.", listed(results.machines)));
  if (!results.builds.empty()) facts.push_back(fmt::format("Program: {}.", listed(results.builds)));
  if (results.builds.size() > 1)
    facts.push_back("The runs are of different builds: differences may be those of the program.");
  return facts;
}

/// "it-svo 1 of 3 on kitti_00": what the means over the runs that count do not show.
std::string partlyFailed(const BenchResults& results) {
  std::string text;
  for (std::size_t s = 0; s < results.runs.size(); ++s) {
    for (std::size_t m = 0; m < static_cast<std::size_t>(results.own); ++m) {
      const std::vector<RunResult>& runs = results.runs[s][m];
      const auto good =
          std::count_if(runs.begin(), runs.end(), [](const RunResult& r) { return r.good; });
      if (good == 0 || good == static_cast<std::ptrdiff_t>(runs.size())) continue;
      text += fmt::format("{}{} {} of {} on {}", text.empty() ? "" : ", ",
                          results.systems[m].system.label, good, runs.size(),
                          results.config.sequences[s].name);
    }
  }
  return text;
}

/// How many sequences each system completes, and whether it starts where nothing moves.
std::vector<std::string> completions(const BenchResults& results) {
  std::string completed, wrong, still;
  for (std::size_t m = 0; m < static_cast<std::size_t>(results.own); ++m) {
    int moving = 0, done = 0;
    for (std::size_t s = 0; s < results.runs.size(); ++s) {
      const bool good = results.typical(s, m) != nullptr;
      const BenchSequence& sequence = results.config.sequences[s];
      if (sequence.still && good)
        wrong += fmt::format("{}{} on {}", wrong.empty() ? "" : ", ",
                             results.systems[m].system.label, sequence.name);
      if (sequence.still) continue;
      ++moving;
      done += good;
    }
    completed += fmt::format("{}{} {} of {}", completed.empty() ? "" : ", ",
                             results.systems[m].system.label, done, moving);
  }
  for (const BenchSequence& sequence : results.config.sequences) {
    if (sequence.still) still += (still.empty() ? "" : ", ") + sequence.name;
  }
  std::vector<std::string> sentences = {"Sequences completed in at least one run: " + completed +
                                        "."};
  const std::string partly = partlyFailed(results);
  if (!partly.empty()) sentences.push_back("Completed in some runs only: " + partly + ".");
  if (!wrong.empty())
    sentences.push_back("Starts although the camera stands still: " + wrong + ".");
  if (!still.empty() && wrong.empty())
    sentences.push_back("Where the camera stands still no system starts: " + still + ".");
  return sentences;
}

void addFindings(const BenchResults& results, Report& report) {
  report.findings.emplace_back("All systems", completions(results));
  for (const auto& [a, b] : comparedPairs(results)) {
    const std::string name =
        results.systems[a].system.label + " against " + results.systems[b].system.label;
    std::vector<std::string> sentences;
    for (const char* key : {"ate_m", "rpe_trans_m", "rpe_rot_rad", "tracking_ms"}) {
      Comparison c = compare(results, a, b, figure(key));
      const std::vector<std::string> all = comparisonSentences(results, c);
      const bool complete = c.figure->value == &RunFigures::ate_m;
      sentences.insert(sentences.end(), all.begin(), complete ? all.end() : all.begin() + 1);
      report.comparisons.push_back(std::move(c));
    }
    report.findings.emplace_back(name, std::move(sentences));
  }
}

std::string csvHeader() {
  std::string text = "sequence,system,method,variant,run,present,counts,reason,exit_code,wall_s";
  for (const FigureInfo& info : figureTable()) text += std::string(",") + info.key;
  return text + "\n";
}

std::string csvRow(const BenchResults& results, std::size_t s, std::size_t m,
                   const RunResult& run) {
  const BenchSystem& system = results.systems[m].system;
  const std::string variant =
      results.systems[m].peer
          ? ""
          : results.config.variants[static_cast<std::size_t>(system.variant)].name;
  std::string text = fmt::format(
      "{},{},{},{},{},{},{},{},{},{:.2f}", csvText(results.config.sequences[s].name),
      csvText(system.label), system.method, csvText(variant), run.run, run.present ? 1 : 0,
      run.good ? 1 : 0, csvText(run.why), run.record.exit_code, run.record.wall_s);
  for (const FigureInfo& info : figureTable()) {
    const auto& value = run.figures.*info.value;
    text += value ? fmt::format(",{:.9g}", *value) : ",";
  }
  return text + "\n";
}

std::string csvOf(const BenchResults& results, bool peers) {
  std::string text = csvHeader();
  for (std::size_t s = 0; s < results.runs.size(); ++s) {
    for (std::size_t m = 0; m < results.systems.size(); ++m) {
      if (results.systems[m].peer != peers) continue;
      for (const RunResult& run : results.runs[s][m]) text += csvRow(results, s, m, run);
    }
  }
  return text;
}

}  // namespace

Report makeReport(const BenchResults& results) {
  Report report;
  report.title = results.config.title;
  report.facts = factsOf(results);
  addFindings(results, report);
  report.tables.push_back(errorTable(results));
  if (results.systems.size() > static_cast<std::size_t>(results.own))
    report.tables.push_back(peerTable(results));
  if (!report.comparisons.empty()) {
    report.tables.push_back(comparisonTable(results, report.comparisons));
    report.tables.push_back(ratioTable(results, report.comparisons));
  }
  const auto add = [&](const char* key, const char* note) {
    report.tables.push_back(figureTableOf(results, key, note));
  };
  add("tracked", "Fraction of the frames since the first pose that have one.");
  add("keyframes", "In the map at the end.");
  add("init_time_s", "Sequence time from the first frame to the first pose.");
  add("relocalisation_time_s",
      "Mean sequence time from a loss to the next pose; - never lost, never found again, or "
      "failed.");
  add("losses", "How often tracking was lost.");
  add("fps", "Frames / wall-clock time of the run, reading images included.");
  add("tracking_ms", "Median over the frames of the time the tracking thread takes.");
  const ReportTable failures = failureTable(results);
  if (!failures.rows.empty()) report.tables.push_back(failures);
  report.paper_tables = paperTables(results);
  return report;
}

std::string reportMarkdown(const Report& report) {
  std::string text = fmt::format("# {}\n\n", report.title);
  for (const std::string& fact : report.facts) text += fact + "\n";
  text += "\n## In short\n\n";
  for (const auto& [pair, sentences] : report.findings) {
    text += fmt::format("**{}**\n\n", pair);
    for (const std::string& sentence : sentences) text += "- " + sentence + "\n";
    text += "\n";
  }
  text += "## Tables\n\n";
  for (const ReportTable& table : report.tables) text += tableMarkdown(table);
  text += fmt::format(
      "## Beside the paper\n\n{}. \"here\" is this benchmark where it ran the same sequence.\n\n",
      kPaperCitation);
  for (const ReportTable& table : report.paper_tables) text += tableMarkdown(table);
  return text;
}

std::string reportLatex(const Report& report) {
  std::string text =
      "% Tables of a benchmark with svoscope; the document needs \\usepackage{booktabs}.\n\n";
  for (const ReportTable& table : report.tables) text += tableLatex(table) + "\n";
  text += fmt::format("% Figures of the paper: {}\n\n", kPaperCitation);
  for (const ReportTable& table : report.paper_tables) text += tableLatex(table) + "\n";
  return text;
}

std::string resultsCsv(const BenchResults& results) { return csvOf(results, false); }
std::string peersCsv(const BenchResults& results) { return csvOf(results, true); }

Status writeReport(const fs::path& dir) {
  const auto results = readBenchResults(dir);
  if (!results.ok()) return results.error();
  const Report report = makeReport(results.value());
  Status status = writeWhole(dir / "results.csv", resultsCsv(results.value()));
  if (status.ok() && !results.value().config.peers.empty())
    status = writeWhole(dir / "peers.csv", peersCsv(results.value()));
  if (status.ok()) status = writeWhole(dir / "report.md", reportMarkdown(report));
  if (status.ok()) status = writeWhole(dir / "tables.tex", reportLatex(report));
  if (status.ok()) status = writeWhole(dir / "report.html", reportHtml(results.value(), report));
  return status;
}

}  // namespace svoscope
