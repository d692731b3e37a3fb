// SPDX-License-Identifier: MIT
#include "engine/eval/trajectory_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <optional>

#include "engine/base/text_rows.h"
#include "engine/eval/trajectory_rows.h"

namespace svoscope {

namespace {

namespace fs = std::filesystem;

// More repeated timestamps than this fraction are no slip of the recorder.
constexpr double kMostRepeats = 0.1;

/// Whether the first row of numbers has commas; the rows themselves no longer tell.
bool separatedByCommas(const fs::path& file) {
  std::ifstream in(file);
  std::string line;
  while (std::getline(in, line)) {
    const auto first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos) continue;
    const auto c = static_cast<unsigned char>(line[first]);
    if (std::isdigit(c) || c == '-' || c == '+' || c == '.') {
      return line.find(',') != std::string::npos;
    }
  }
  return false;
}

/// Names of the columns in a first line without '#', as some tools write it.
bool isHeader(const TextRow& row) {
  const std::string& name = row.fields[0];
  const auto first = static_cast<unsigned char>(name[0]);
  return (std::isalpha(first) || first == '"') && !parseNumber(name);  // "nan" is no name
}

/// A row with its time and pose, and where it stands.
struct ReadRow {
  double timestamp = 0;
  RowPose pose;
  int line = 0;
};

/// Times of all rows; KITTI rows count from zero.
Result<std::vector<double>> timesOf(const std::vector<TextRow>& rows, std::size_t first,
                                    TrajectoryFormat format, const fs::path& file) {
  std::vector<double> times;
  if (format == TrajectoryFormat::kitti) {
    for (std::size_t i = first; i < rows.size(); ++i)
      times.push_back(static_cast<double>(i - first));
    return times;
  }
  std::vector<std::string> fields;
  for (std::size_t i = first; i < rows.size(); ++i) fields.push_back(rows[i].fields[0]);
  std::size_t bad = 0;
  auto stamps = readStamps(fields, &bad);
  if (!stamps) {
    return inputError("'" + fields[bad] + "' is not a finite number",
                      place(file, rows[first + bad].line), kTrajectoryLayouts);
  }
  return std::move(stamps->seconds);
}

/// Rows without a pose: passed over in a ground truth, an error in an estimate. A ground truth with
/// mostly positions is one of positions.
Status dropBadRows(std::vector<ReadRow>& rows, TrajectoryUse use, const fs::path& file,
                   TrajectoryFile& result) {
  const auto bad = [&](const ReadRow& r) {
    return !r.pose.finite || (!r.pose.oriented && !result.positions_only);
  };
  const auto unoriented = std::count_if(
      rows.begin(), rows.end(), [](const ReadRow& r) { return r.pose.finite && !r.pose.oriented; });
  if (use == TrajectoryUse::ground_truth && result.format != TrajectoryFormat::kitti &&
      2 * static_cast<std::size_t>(unoriented) > rows.size()) {
    result.positions_only = true;
    result.warnings.push_back(fmt::format(
        "{}: {} of {} rows have no orientation (zero or not finite): only positions are used",
        file.string(), unoriented, rows.size()));
  }
  const auto first = std::find_if(rows.begin(), rows.end(), bad);
  if (first == rows.end()) return Done{};
  const bool matrix = result.format == TrajectoryFormat::kitti;  // rows are numbered: none may go
  if (use == TrajectoryUse::estimate || matrix || first->pose.problem.find("length") == 15) {
    return inputError(first->pose.problem, place(file, first->line), kTrajectoryLayouts);
  }
  result.skipped_rows = static_cast<int>(std::count_if(rows.begin(), rows.end(), bad));
  result.warnings.push_back(fmt::format("{}: {} of {} rows are passed over: {}",
                                        place(file, first->line), result.skipped_rows, rows.size(),
                                        first->pose.problem));
  rows.erase(std::remove_if(rows.begin(), rows.end(), bad), rows.end());
  if (rows.empty())
    return inputError("the file holds no finite pose", file.string(), kTrajectoryLayouts);
  return Done{};
}

Status bringInOrder(std::vector<ReadRow>& rows, TrajectoryUse use, const fs::path& file,
                    TrajectoryFile& result) {
  const auto earlier = [](const ReadRow& a, const ReadRow& b) { return a.timestamp < b.timestamp; };
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (!earlier(rows[i], rows[i - 1])) continue;
    if (use == TrajectoryUse::estimate) {
      return inputError(
          fmt::format("timestamp {:.6f} is earlier than the one above", rows[i].timestamp),
          place(file, rows[i].line), "sort the rows by time");
    }
    std::stable_sort(rows.begin(), rows.end(), earlier);
    result.warnings.push_back(place(file, rows[i].line) + ": the rows were sorted by time");
    break;
  }
  return Done{};
}

/// Lines whose timestamp repeats the one above: few give a warning, many an error.
Status judgeRepeats(const std::vector<int>& lines, const fs::path& file, TrajectoryUse use,
                    TrajectoryFile& result) {
  if (lines.empty()) return Done{};
  if (use == TrajectoryUse::estimate) {
    return inputError(
        fmt::format("the timestamp is that of the row above ({} such rows)", lines.size()),
        place(file, lines.front()),
        "an estimate has one pose for a time: drop the rows, or write more digits");
  }
  const std::size_t rows = result.poses.size() + lines.size();
  const std::string what =
      fmt::format("{} of {} timestamps repeat the one above", lines.size(), rows);
  if (static_cast<double>(lines.size()) > kMostRepeats * static_cast<double>(rows)) {
    return inputError(what, place(file, lines.front()),
                      "were they written with all their digits? each pose needs its own time");
  }
  result.warnings.push_back(
      fmt::format("{}: {}; the first of such rows is used", place(file, lines.front()), what));
  return Done{};
}

Result<std::vector<ReadRow>> readRows(const std::vector<TextRow>& rows, std::size_t first,
                                      const RowForm& form, const fs::path& file) {
  const auto times = timesOf(rows, first, form.format, file);
  if (!times.ok()) return times.error();
  std::vector<ReadRow> result;
  for (std::size_t i = first; i < rows.size(); ++i) {
    auto pose = poseOfRow(rows[i], form, place(file, rows[i].line));
    if (!pose.ok()) return pose.error();
    result.push_back({times.value()[i - first], std::move(pose).value(), rows[i].line});
  }
  return result;
}

}  // namespace

const char* trajectoryFormatName(TrajectoryFormat format) {
  switch (format) {
    case TrajectoryFormat::tum:
      return "TUM";
    case TrajectoryFormat::euroc:
      return "EuRoC";
    case TrajectoryFormat::kitti:
      return "KITTI";
  }
  return "unknown";
}

Result<TrajectoryFile> loadTrajectory(const fs::path& file, const TrajectoryReading& reading) {
  const auto text = readTextRows(file, "expected a trajectory file");
  if (!text.ok()) return text.error();
  const std::vector<TextRow>& lines = text.value();
  const std::size_t first = !lines.empty() && isHeader(lines.front()) ? 1 : 0;
  if (lines.size() == first)
    return inputError("the file holds no pose", file.string(), kTrajectoryLayouts);
  auto form = recogniseForm(lines[first], separatedByCommas(file));
  if (!form) {
    return inputError(fmt::format("{} columns are no known format", lines[first].fields.size()),
                      place(file, lines[first].line), kTrajectoryLayouts);
  }
  form->quaternion = reading.quaternion;
  TrajectoryFile result;
  result.format = form->format;
  result.positions_only = !form->orientation;
  auto rows = readRows(lines, first, *form, file);
  if (!rows.ok()) return rows.error();
  Status good = dropBadRows(rows.value(), reading.use, file, result);
  if (good.ok()) good = bringInOrder(rows.value(), reading.use, file, result);
  if (!good.ok()) return good.error();
  std::vector<int> repeated;
  for (const ReadRow& row : rows.value()) {
    if (!result.poses.empty() && row.timestamp == result.poses.back().timestamp) {
      repeated.push_back(row.line);
    } else {
      result.poses.push_back({row.timestamp, row.pose.pose});
    }
  }
  const Status judged = judgeRepeats(repeated, file, reading.use, result);
  if (!judged.ok()) return judged.error();
  return result;
}

}  // namespace svoscope
