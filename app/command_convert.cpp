// SPDX-License-Identifier: MIT
// svoscope convert: trajectories from one text format into another.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "app/command.h"
#include "engine/base/text_rows.h"
#include "engine/eval/trajectory_file.h"
#include "engine/io/trajectory_writer.h"

namespace svoscope {

namespace {

constexpr const char* kFooter =
    "The format of TRAJECTORY (TUM, EuRoC CSV, KITTI rows) is recognised. KITTI rows have no\n"
    "timestamps: --times gives those of their rows. Written as KITTI, timestamps are lost.\n"
    "\n"
    "Examples:\n"
    "  svoscope convert results/trajectory.txt --to euroc --out trajectory.csv\n"
    "  svoscope convert poses/00.txt --times sequences/00/times.txt --to tum --out 00.txt";

struct Arguments {
  std::string trajectory, to, out, times;
};

/// Gives row i of KITTI the i-th time of the file.
Status addTimes(TrajectoryFile& file, const std::string& times_file) {
  const auto rows = readTextRows(times_file, "one time in seconds a line");
  if (!rows.ok()) return rows.error();
  if (rows.value().size() != file.poses.size()) {
    return inputError(fmt::format("{} times for {} rows", rows.value().size(), file.poses.size()),
                      times_file, "give one time for each row of the trajectory");
  }
  for (std::size_t i = 0; i < file.poses.size(); ++i) {
    const auto number =
        finiteNumbers(rows.value()[i], 0, 1, times_file, "one time in seconds a line");
    if (!number.ok()) return number.error();
    file.poses[i].timestamp = number.value()[0];
    if (i > 0 && file.poses[i].timestamp <= file.poses[i - 1].timestamp) {
      return inputError("the time is not later than the one above",
                        place(times_file, rows.value()[i].line), "times increase from row to row");
    }
  }
  return Done{};
}

Status checkTimes(const Arguments& arguments, bool rows) {
  if (!rows && !arguments.times.empty())
    return usageError("the trajectory has timestamps of its own", "--times", "leave it out");
  if (rows && arguments.times.empty() && arguments.to != "kitti")
    return inputError("KITTI rows have no timestamps", arguments.trajectory,
                      "give them with --times FILE");
  return Done{};
}

Status write(const Arguments& arguments, const Trajectory& poses) {
  if (arguments.to == "tum") return writeTumTrajectory(arguments.out, poses);
  if (arguments.to == "euroc") return writeEurocTrajectory(arguments.out, poses);
  return writeKittiTrajectory(arguments.out, poses);
}

int runConvert(const Arguments& arguments) {
  auto loaded = loadTrajectory(arguments.trajectory);
  if (!loaded.ok()) return reportError(loaded.error());
  TrajectoryFile& file = loaded.value();
  for (const std::string& warning : file.warnings) reportWarning(warning);
  const bool rows = file.format == TrajectoryFormat::kitti;
  Status status = checkTimes(arguments, rows);
  if (status.ok() && !arguments.times.empty()) status = addTimes(file, arguments.times);
  if (status.ok()) status = write(arguments, file.poses);
  if (!status.ok()) return reportError(status.error());
  fmt::print("{} poses of {} ({}) in {}\n", file.poses.size(), arguments.trajectory,
             trajectoryFormatName(file.format), arguments.out);
  return kExitDone;
}

}  // namespace

void addConvertCommand(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("convert", "Write a trajectory as TUM, EuRoC or KITTI");
  command->footer(kFooter);
  command->add_option("TRAJECTORY", arguments->trajectory, "Trajectory of any system")->required();
  command->add_option("--to", arguments->to, "Format to write")
      ->check(CLI::IsMember({"tum", "euroc", "kitti"}))
      ->required();
  command->add_option("--out", arguments->out, "File to write")->required()->type_name("FILE");
  command->add_option("--times", arguments->times, "Times of KITTI rows, seconds, one a line")
      ->type_name("FILE");
  command->callback(
      [arguments, &action] { action = [arguments] { return runConvert(*arguments); }; });
}

}  // namespace svoscope
