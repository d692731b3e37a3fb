// SPDX-License-Identifier: MIT
// svoscope bench: methods on many sequences, with a report.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/command.h"
#include "app/interrupt.h"
#include "engine/bench/bench_runner.h"
#include "engine/report/report.h"

namespace svoscope {

namespace {

namespace fs = std::filesystem;

constexpr const char* kFooter =
    "Runs sequences x methods x variants x runs of CONFIG (docs/bench.md) and writes report.html,\n"
    "report.md, tables.tex and results.csv into DIR. Finished runs are kept: the same command\n"
    "goes on after an interruption. Shards write no report; with a common DIR give --report once\n"
    "all are done, with folders of their own --merge.\n"
    "\n"
    "Examples:\n"
    "  svoscope bench assets/bench/synthetic.yaml --out bench\n"
    "  svoscope bench CONFIG --out bench --shard 3/8\n"
    "  svoscope bench --report --out bench\n"
    "  svoscope bench --merge part1 part2 --out bench";

struct Arguments {
  std::string config, out, shard = "1/1";
  std::vector<std::string> merge;
  int jobs = 1;
  bool report = false, list = false, retry_failed = false, any_build = false;
};

/// "2/8" as two numbers with 1 <= first <= second.
bool parseShard(const std::string& text, int& shard, int& shards) {
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, shard);
  if (first.ec != std::errc() || first.ptr == end || *first.ptr != '/') return false;
  const auto second = std::from_chars(first.ptr + 1, end, shards);
  return second.ec == std::errc() && second.ptr == end && shard >= 1 && shard <= shards;
}

int reportOn(const fs::path& dir) {
  const Status written = writeReport(dir);
  if (!written.ok()) return reportError(written.error());
  fmt::print("{}\n", (dir / "report.html").string());
  return kExitDone;
}

int list(const BenchConfig& config) {
  const std::vector<BenchSystem> systems = config.systems();
  for (const BenchCell& cell : cellsOf(config)) {
    fmt::print("{} {} run {}\n", config.sequences[static_cast<std::size_t>(cell.sequence)].name,
               systems[static_cast<std::size_t>(cell.system)].label, cell.run);
  }
  return kExitDone;
}

int mergeAndReport(const Arguments& arguments) {
  const Status merged = mergeBench({arguments.merge.begin(), arguments.merge.end()}, arguments.out);
  if (!merged.ok()) return reportError(merged.error());
  return reportOn(arguments.out);
}

int runAndReport(const Arguments& arguments, const BenchConfig& config, BenchOptions options) {
  const InterruptGuard guard;
  options.out = arguments.out;
  options.program = fs::read_symlink("/proc/self/exe");
  options.version = SVOSCOPE_VERSION;
  options.jobs = arguments.jobs;
  options.retry_failed = arguments.retry_failed;
  options.any_build = arguments.any_build;
  options.stop = &guard.flag();
  options.say = [](const std::string& line) { std::fprintf(stderr, "%s\n", line.c_str()); };
  options.warn = reportWarning;
  const auto outcome = runBench(config, options);
  if (!outcome.ok()) return reportError(outcome.error());
  if (outcome.value().interrupted) {
    reportWarning("interrupted; finished runs are kept, the same command goes on from here");
    return kExitInterrupted;
  }
  if (options.shards > 1) {
    std::fprintf(stderr, "shard %d of %d is done; when all are: svoscope bench --report --out %s\n",
                 options.shard, options.shards, arguments.out.c_str());
    return kExitDone;
  }
  return reportOn(arguments.out);
}

int runBenchCommand(const Arguments& arguments) {
  const std::string help = "see svoscope bench --help";
  BenchOptions options;
  if (!parseShard(arguments.shard, options.shard, options.shards))
    return reportError(usageError("'" + arguments.shard + "' is not k/n with 1 <= k <= n",
                                  "--shard", "as in --shard 2/8"));
  if (!arguments.merge.empty() || (arguments.report && arguments.config.empty())) {
    if (!arguments.config.empty())
      return reportError(usageError("--merge takes folders only", arguments.config, help));
    if (arguments.out.empty()) return reportError(usageError("--out is missing", "", help));
    return arguments.merge.empty() ? reportOn(arguments.out) : mergeAndReport(arguments);
  }
  if (arguments.config.empty()) return reportError(usageError("no configuration given", "", help));
  const auto config = loadBenchConfig(arguments.config);
  if (!config.ok()) return reportError(config.error());
  if (arguments.list) return list(config.value());
  if (arguments.out.empty()) return reportError(usageError("--out is missing", "", help));
  if (arguments.report) return reportOn(arguments.out);
  return runAndReport(arguments, config.value(), options);
}

}  // namespace

void addBenchCommand(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("bench", "Run methods on many sequences and report");
  command->footer(kFooter);
  command->add_option("CONFIG", arguments->config, "YAML file: what to run");
  command->add_option("--out", arguments->out, "Folder of runs and report, made if absent")
      ->type_name("DIR");
  command->add_option("--jobs", arguments->jobs, "Runs at a time; more than one disturbs times")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command->add_option("--shard", arguments->shard, "Only part k of n")->type_name("K/N");
  command->add_option("--merge", arguments->merge, "Take the runs of these folders together in DIR")
      ->type_name("DIR...");
  command->add_flag("--report", arguments->report, "Only write the report of what is in DIR");
  command->add_flag("--list", arguments->list, "Only print the runs");
  command->add_flag("--retry-failed", arguments->retry_failed, "Run those again that failed");
  command->add_flag("--any-build", arguments->any_build,
                    "Keep runs of another build of the program");
  command->callback(
      [arguments, &action] { action = [arguments] { return runBenchCommand(*arguments); }; });
}

}  // namespace svoscope
