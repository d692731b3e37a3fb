// SPDX-License-Identifier: MIT
// svoscope eval: errors of trajectories from any system against ground truth.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/command.h"
#include "app/eval_input.h"
#include "engine/eval/conventions.h"
#include "engine/eval/evaluate.h"
#include "engine/eval/trajectory_file.h"
#include "engine/io/eval_plots.h"
#include "engine/io/metrics_writer.h"

namespace svoscope {

namespace {

constexpr const char* kFooter =
    "GROUNDTRUTH is a trajectory or a sequence that has one. Formats (TUM, EuRoC CSV, KITTI rows)\n"
    "are recognised. Poses are matched by timestamp; KITTI rows, which have none, by row number.\n"
    "Conventions: docs/evaluation.md.\n"
    "\n"
    "Examples:\n"
    "  svoscope eval groundtruth.txt trajectory.txt\n"
    "  svoscope eval SEQUENCE trajectory.txt\n"
    "  svoscope eval mocap0/data.csv a.txt --extrinsics sensor.yaml\n"
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
  EvalConventions conventions;
};

/// The options for one estimate: whether rows or timestamps are matched depends on both files.
Result<EvalOptions> optionsFor(const Arguments& arguments, const TrajectoryFile& gt,
                               const TrajectoryFile& est, const std::string& est_name) {
  EvalOptions options;
  options.alignment = parseAlignment(arguments.align).value();  // checked by the parser
  options.align_first = arguments.align_first;
  options.max_dt = arguments.max_dt;
  options.time_offset = arguments.offset;
  options.all_pairs = arguments.all_pairs;
  options.orientations = !gt.positions_only && !est.positions_only;
  const bool gt_rows = gt.format == TrajectoryFormat::kitti;
  const bool est_rows = est.format == TrajectoryFormat::kitti;
  if (gt_rows != est_rows) {
    return inputError(
        "only one of the two files has timestamps", est_name,
        "give the rows their times: svoscope convert ROWS --times times.txt --to tum --out FILE");
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

/// What would fit far better by another convention, with the option that applies it.
void sayDoubts(const TrajectoryFile& gt, const TrajectoryFile& est, const EvalResult& result,
               const std::string& est_name) {
  if (result.straight)
    reportWarning(est_name + ": all positions lie on a line: the turn about it is left open");
  const bool gt_tum = gt.format == TrajectoryFormat::tum && !gt.positions_only;
  const bool est_tum = est.format == TrajectoryFormat::tum && !est.positions_only;
  for (const ConventionDoubt& doubt :
       conventionDoubts(gt.poses, est.poses, result, gt_tum, est_tum))
    reportWarning(fmt::format("{}: {} ({})", est_name, doubt.text, doubt.option));
}

Result<EvalResult> evaluateFile(const Arguments& arguments, const TrajectoryFile& gt,
                                const std::string& est_name) {
  const auto est = loadEstimate(est_name, arguments.conventions);
  if (!est.ok()) return est.error();
  const auto options = optionsFor(arguments, gt, est.value(), est_name);
  if (!options.ok()) return options.error();
  auto result = evaluate(gt.poses, est.value().poses, options.value());
  if (result.ok()) {
    sayDoubts(gt, est.value(), result.value(), est_name);
    return result;
  }
  Error error = result.error();
  error.where = est_name + ", " + error.where;
  const std::string clock = clockDoubt(gt.poses, est.value().poses);
  if (!clock.empty() && !options.value().by_row) error.remedy = clock;
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
                                       {"coverage", result.coverage},
                                       {"rpe_note", result.rpe_note},
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
  fmt::print("{:<32} {:>5} {:>9} {:>11} {:>8} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>6}\n",
             "estimate", "align", "scale", "matched", "covered", "ATE rmse", "mean", "median",
             "max", "std", "RPE m", "RPE rad", "pairs");
  for (const auto& [name, r] : rows) {
    fmt::print(
        "{:<32} {:>5} {:>9.6f} {:>11} {:>7.1f}% {:>9.6f} {:>9.6f} {:>9.6f} {:>9.6f} {:>9.6f} ",
        shortened(name, 32), alignmentName(r.options.alignment), r.scale,
        fmt::format("{}/{}", r.matched, r.poses_est), 100 * r.coverage, r.ate.rmse, r.ate.mean,
        r.ate.median, r.ate.max, r.ate.stddev);
    if (r.rpe) {
      fmt::print("{:>9.6f} {:>9.6f} {:>6}\n", r.rpe->trans_rmse_m, r.rpe->rot_rmse_rad,
                 r.rpe->pairs);
    } else {
      fmt::print("{:>9} {:>9} {:>6}  ({})\n", "-", "-", 0, r.rpe_note);
    }
  }
  const EvalOptions& o = rows.front().result.options;
  fmt::print("\nATE in m over {} poses of ground truth; matched by {}; alignment {}\n",
             rows.front().result.poses_gt, associationText(o), alignmentText(o));
  fmt::print("covered: share of the ground truth's time between matches at most a second apart\n");
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
  const auto gt = loadGroundTruth(arguments.ground_truth, arguments.conventions);
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
  command
      ->add_option("GROUNDTRUTH", arguments->ground_truth,
                   "Trajectory taken as true, or a sequence that has one")
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
  EvalConventions& conventions = arguments->conventions;
  command
      ->add_option("--extrinsics", conventions.extrinsics,
                   "Calibration with T_BS or T_cam_imu: GROUNDTRUTH is of the body")
      ->type_name("FILE");
  command
      ->add_option("--quaternion", conventions.quaternion,
                   "Order in TUM files: of both, or of one begun with w [xyzw]")
      ->check(CLI::IsMember({"xyzw", "wxyz", "gt-wxyz", "est-wxyz"}));
  command->add_flag("--invert", conventions.invert,
                    "The estimates hold poses of the world in the camera");
  command->add_flag("--mirror", conventions.mirror, "The estimates are of a left-handed world");
  command->add_flag("--json", arguments->json, "One JSON object a line for each estimate");
  command->callback([arguments, &action] { action = [arguments] { return runEval(*arguments); }; });
}

}  // namespace svoscope
