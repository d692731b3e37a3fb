// SPDX-License-Identifier: MIT
// svoscope eval: errors of trajectories from any system against ground truth.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/command.h"
#include "engine/eval/evaluate.h"
#include "engine/eval/trajectory_file.h"
#include "engine/io/eval_plots.h"
#include "engine/io/metrics_writer.h"

namespace svoscope {

namespace {

constexpr const char* kFooter =
    "Formats (TUM, EuRoC CSV, KITTI rows) are recognised. Poses are matched by timestamp; KITTI\n"
    "rows, which have none, by row number. Conventions: docs/evaluation.md.\n"
    "\n"
    "Examples:\n"
    "  svoscope eval groundtruth.txt trajectory.txt\n"
    "  svoscope eval groundtruth.txt a.txt b.txt --align se3 --delta 30f --all-pairs\n"
    "  svoscope eval groundtruth.txt a.txt --align-first 100 --plots figures\n"
    "  svoscope eval poses/00.txt orb.txt --delta 10m --json";

struct Arguments {
  std::string ground_truth;
  std::vector<std::string> estimates;
  std::string align = "sim3";
  int align_first = 0;
  double max_dt = 0.02, offset = 0;
  std::string delta, plots;
  bool all_pairs = false;
  bool json = false;
};

Result<TrajectoryFile> load(const std::string& file, RepeatedStamps repeats) {
  auto loaded = loadTrajectory(file, repeats);
  if (loaded.ok()) {
    for (const std::string& warning : loaded.value().warnings) reportWarning(warning);
  }
  return loaded;
}

/// The options for one estimate: whether rows or timestamps are matched depends on both files.
Result<EvalOptions> optionsFor(const Arguments& arguments, const TrajectoryFile& gt,
                               const TrajectoryFile& est, const std::string& est_name) {
  EvalOptions options;
  options.alignment = parseAlignment(arguments.align).value();  // checked by the parser
  options.align_first = arguments.align_first;
  options.max_dt = arguments.max_dt;
  options.time_offset = arguments.offset;
  options.all_pairs = arguments.all_pairs;
  const bool gt_rows = gt.format == TrajectoryFormat::kitti;
  const bool est_rows = est.format == TrajectoryFormat::kitti;
  if (gt_rows != est_rows) {
    return inputError("only one of the two files has timestamps", est_name,
                      "give both as KITTI rows, or both with timestamps");
  }
  options.by_row = gt_rows;
  if (options.by_row && options.time_offset != 0) {
    return usageError("KITTI rows have no timestamps to shift", "--offset", "leave it out");
  }
  const std::string standard = options.by_row ? "10m" : "1s";
  const auto delta = parseDelta(arguments.delta.empty() ? standard : arguments.delta);
  if (!delta.ok()) return delta.error();
  options.delta = delta.value();
  if (options.by_row && options.delta.unit == Delta::Unit::seconds) {
    return usageError("KITTI rows have no timestamps", "--delta " + options.delta.text(),
                      "give the interval in frames (10f) or metres (10m)");
  }
  return options;
}

Result<EvalResult> evaluateFile(const Arguments& arguments, const TrajectoryFile& gt,
                                const std::string& est_name) {
  const auto est = load(est_name, RepeatedStamps::reject);
  if (!est.ok()) return est.error();
  const auto options = optionsFor(arguments, gt, est.value(), est_name);
  if (!options.ok()) return options.error();
  auto result = evaluate(gt.poses, est.value().poses, options.value());
  if (result.ok()) return result;
  Error error = result.error();
  error.where = est_name + ", " + error.where;
  return error;
}

void printJson(const Arguments& arguments, const std::string& est_name, const EvalResult& result) {
  nlohmann::ordered_json association = {
      {"matched_by", result.options.by_row ? "row" : "timestamp"}};
  if (!result.options.by_row) {
    association["max_dt_s"] = result.options.max_dt;
    association["offset_s"] = result.options.time_offset;
  }
  const nlohmann::ordered_json json = {{"ground_truth", arguments.ground_truth},
                                       {"estimate", est_name},
                                       {"association", association},
                                       {"aligned_on", result.aligned_on},
                                       {"ate", ateJson(result)},
                                       {"rpe", rpeJson(result)}};
  fmt::print("{}\n", json.dump());
}

std::string shortened(const std::string& name, std::size_t width) {
  return name.size() <= width ? name : "..." + name.substr(name.size() - width + 3);
}

std::string associationText(const EvalOptions& o) {
  if (o.by_row) return "row";
  const std::string text = fmt::format("timestamp within {} s", o.max_dt);
  return o.time_offset == 0 ? text
                            : text + fmt::format(", {:+} s added to the estimates'", o.time_offset);
}

std::string alignmentText(const EvalOptions& o) {
  if (o.alignment == Alignment::none) return "none: positions as given";
  const std::string poses =
      o.align_first > 0 ? fmt::format("up to the first {} matches", o.align_first) : "all matches";
  const char* free = o.alignment == Alignment::se3 ? "rotation and translation"
                                                   : "rotation, translation and scale";
  return fmt::format("{}: {}, on {}", alignmentName(o.alignment), free, poses);
}

void printTable(const std::vector<NamedEval>& rows) {
  fmt::print("{:<32} {:>5} {:>9} {:>11} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}\n", "estimate",
             "align", "scale", "matched", "ATE rmse", "mean", "median", "max", "std", "RPE m",
             "RPE rad");
  for (const auto& [name, r] : rows) {
    fmt::print("{:<32} {:>5} {:>9.6f} {:>11} {:>9.6f} {:>9.6f} {:>9.6f} {:>9.6f} {:>9.6f} ",
               shortened(name, 32), alignmentName(r.options.alignment), r.scale,
               fmt::format("{}/{}", r.matched, r.poses_est), r.ate.rmse, r.ate.mean, r.ate.median,
               r.ate.max, r.ate.stddev);
    if (r.rpe) {
      fmt::print("{:>9.6f} {:>9.6f}\n", r.rpe->trans_rmse_m, r.rpe->rot_rmse_rad);
    } else {
      fmt::print("{:>9} {:>9}\n", "-", "-");
    }
  }
  const EvalOptions& o = rows.front().result.options;
  fmt::print("\nATE in m over {} poses of ground truth; matched by {}; alignment {}\n",
             rows.front().result.poses_gt, associationText(o), alignmentText(o));
  fmt::print("RPE rmse over {}, {} pairs\n", o.delta.text(), o.all_pairs ? "all" : "consecutive");
}

int runEval(const Arguments& arguments) {
  if (!arguments.delta.empty()) {
    const auto delta = parseDelta(arguments.delta);
    if (!delta.ok()) return reportError(delta.error());
  }
  if (arguments.align_first != 0 && arguments.align == "none") {
    return reportError(usageError("nothing is aligned with --align none", "--align-first",
                                  "leave one of them out"));
  }
  const auto gt = load(arguments.ground_truth, RepeatedStamps::warn);
  if (!gt.ok()) return reportError(gt.error());
  int exit_code = kExitDone;
  std::vector<NamedEval> rows;
  for (const std::string& estimate : arguments.estimates) {
    auto result = evaluateFile(arguments, gt.value(), estimate);
    if (!result.ok()) {
      exit_code = reportError(result.error());  // the others are still worth having
    } else {
      if (result.value().aligned_on < arguments.align_first) {
        reportWarning(fmt::format("{}: there are only {} matches, aligned on all of them", estimate,
                                  result.value().aligned_on));
      }
      if (arguments.json) printJson(arguments, estimate, result.value());
      rows.push_back({estimate, std::move(result).value()});
    }
  }
  if (!rows.empty() && !arguments.json) printTable(rows);
  if (!rows.empty() && !arguments.plots.empty()) {
    const Status written = writeEvalPlots(arguments.plots, gt.value().poses, rows);
    if (!written.ok()) return reportError(written.error());
  }
  return exit_code;
}

}  // namespace

void addEvalCommand(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      app.add_subcommand("eval", "ATE and RPE of trajectories against ground truth");
  command->footer(kFooter);
  command->add_option("GROUNDTRUTH", arguments->ground_truth, "Trajectory taken as true")
      ->required();
  command->add_option("ESTIMATE", arguments->estimates, "One or more trajectories")->required();
  command->add_option("--align", arguments->align, "Alignment before comparing")
      ->check(CLI::IsMember({"none", "se3", "sim3"}))
      ->capture_default_str();
  command
      ->add_option("--align-first", arguments->align_first,
                   "Align on the first N matches only [all]")
      ->check(CLI::Range(3, 1000000000))
      ->type_name("N");
  command->add_option("--max-dt", arguments->max_dt, "Association limit, seconds")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  command
      ->add_option("--offset", arguments->offset,
                   "Seconds added to the timestamps of the estimates")
      ->check(CLI::Range(-1e12, 1e12))
      ->type_name("S");
  command->add_option("--delta", arguments->delta,
                      "Interval of the RPE: 1s, 30f (frames), 10m [1s; 10m for KITTI rows]");
  command->add_flag("--all-pairs", arguments->all_pairs,
                    "RPE over all pairs, not consecutive ones");
  command
      ->add_option("--plots", arguments->plots,
                   "Folder for trajectories.svg, error.svg, errors.csv")
      ->type_name("DIR");
  command->add_flag("--json", arguments->json, "One JSON object a line for each estimate");
  command->callback([arguments, &action] { action = [arguments] { return runEval(*arguments); }; });
}

}  // namespace svoscope
