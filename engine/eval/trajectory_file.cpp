// SPDX-License-Identifier: MIT
#include "engine/eval/trajectory_file.h"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <fstream>
#include <optional>

#include "engine/base/text_rows.h"

namespace svoscope {

namespace {

namespace fs = std::filesystem;

const char* const kLayouts =
    "rows are 'timestamp tx ty tz qx qy qz qw' (TUM), EuRoC CSV or 12 numbers (KITTI), sorted by "
    "time";
// No time in seconds is this large: some systems write nanoseconds into the TUM layout.
constexpr double kSmallestNanoseconds = 1e14;
// Published files carry as few as four decimals, so unit length is met only roughly.
constexpr double kRotationTolerance = 0.1;
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

std::optional<TrajectoryFormat> recognise(const TextRow& row, bool commas) {
  const std::size_t columns = row.fields.size();
  if (!commas && columns == 12) return TrajectoryFormat::kitti;
  const bool whole_stamp = parseNanoseconds(row.fields[0]).has_value();
  if (columns == 8 && !(commas && whole_stamp)) return TrajectoryFormat::tum;
  if (columns >= 8 && commas) return TrajectoryFormat::euroc;
  return std::nullopt;
}

/// Names of the columns in a first line without '#', as some tools write it.
bool isHeader(const TextRow& row) {
  const std::string& name = row.fields[0];
  const auto first = static_cast<unsigned char>(name[0]);
  return (std::isalpha(first) || first == '"') && !parseNumber(name);  // "nan" is no name
}

std::optional<std::string> poseOfQuaternion(const Vec3& t, const Eigen::Quaterniond& q, SE3& pose) {
  const double norm = q.norm();
  if (norm < 1e-9) return std::string("the quaternion is zero");
  if (std::abs(norm - 1.0) > kRotationTolerance) {
    return fmt::format("the quaternion has length {:.4g}, not 1", norm);
  }
  pose = SE3(q, t);
  return std::nullopt;
}

std::optional<std::string> poseOfMatrix(const std::vector<double>& n, SE3& pose) {
  Mat3 R;
  R << n[0], n[1], n[2], n[4], n[5], n[6], n[8], n[9], n[10];
  const double deviation = (R * R.transpose() - Mat3::Identity()).norm();
  if (deviation > kRotationTolerance || R.determinant() < 0) {
    return std::string("the 3x3 part is not a rotation");
  }
  pose = SE3(R, Vec3(n[3], n[7], n[11]));
  return std::nullopt;
}

/// The pose of a row; KITTI rows get `number` as timestamp.
Result<StampedPose> poseOfRow(const TextRow& row, TrajectoryFormat format, int number,
                              const fs::path& file) {
  const std::size_t columns = format == TrajectoryFormat::kitti ? 12 : 8;
  const auto numbers = finiteNumbers(row, 0, columns, file, kLayouts);
  if (!numbers.ok()) return numbers.error();
  if (format != TrajectoryFormat::euroc && row.fields.size() != columns) {
    return inputError(fmt::format("{} fields instead of {}", row.fields.size(), columns),
                      place(file, row.line), kLayouts);
  }
  const auto& n = numbers.value();
  StampedPose pose;
  std::optional<std::string> wrong;
  if (format == TrajectoryFormat::kitti) {
    pose.timestamp = number;
    wrong = poseOfMatrix(n, pose.T_world_cam);
  } else if (format == TrajectoryFormat::euroc) {
    pose.timestamp = parseNanoseconds(row.fields[0]).value_or(n[0] * 1e-9);
    wrong = poseOfQuaternion(Vec3(n[1], n[2], n[3]), Eigen::Quaterniond(n[4], n[5], n[6], n[7]),
                             pose.T_world_cam);
  } else {
    pose.timestamp = std::abs(n[0]) > kSmallestNanoseconds ? n[0] * 1e-9 : n[0];
    wrong = poseOfQuaternion(Vec3(n[1], n[2], n[3]), Eigen::Quaterniond(n[7], n[4], n[5], n[6]),
                             pose.T_world_cam);
  }
  if (wrong) return inputError(*wrong, place(file, row.line), kLayouts);
  return pose;
}

/// Lines whose timestamp repeats the one above: few give a warning, many an error.
Status judgeRepeats(const std::vector<int>& lines, const fs::path& file, RepeatedStamps repeats,
                    TrajectoryFile& result) {
  if (lines.empty()) return Done{};
  if (repeats == RepeatedStamps::reject) {
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

Result<TrajectoryFile> loadTrajectory(const fs::path& file, RepeatedStamps repeats) {
  const auto read = readTextRows(file, "expected a trajectory file");
  if (!read.ok()) return read.error();
  const std::vector<TextRow>& rows = read.value();
  const std::size_t first = !rows.empty() && isHeader(rows.front()) ? 1 : 0;
  if (rows.size() == first) return inputError("the file holds no pose", file.string(), kLayouts);
  const auto format = recognise(rows[first], separatedByCommas(file));
  if (!format) {
    return inputError(fmt::format("{} columns are no known format", rows[first].fields.size()),
                      place(file, rows[first].line), kLayouts);
  }
  TrajectoryFile result;
  result.format = *format;
  std::vector<int> repeated;
  for (std::size_t i = first; i < rows.size(); ++i) {
    const auto pose = poseOfRow(rows[i], *format, static_cast<int>(i - first), file);
    if (!pose.ok()) return pose.error();
    const double previous = result.poses.empty() ? -HUGE_VAL : result.poses.back().timestamp;
    if (pose.value().timestamp < previous) {
      return inputError(
          fmt::format("timestamp {:.6f} is earlier than the one above", pose.value().timestamp),
          place(file, rows[i].line), "sort the rows by time");
    }
    if (pose.value().timestamp == previous) {
      repeated.push_back(rows[i].line);
    } else {
      result.poses.push_back(pose.value());
    }
  }
  const Status judged = judgeRepeats(repeated, file, repeats, result);
  if (!judged.ok()) return judged.error();
  return result;
}

}  // namespace svoscope
