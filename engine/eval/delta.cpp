// SPDX-License-Identifier: MIT
#include "engine/eval/delta.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace svoscope {

namespace {

using Pairs = std::vector<std::pair<int, int>>;
constexpr double kRelativeTolerance = 0.1;
constexpr double kTimeTolerance = 0.02;  // s; below it a frame more or less would decide

Pairs byFrames(int count, int step, bool all_pairs) {
  Pairs pairs;
  for (int i = 0; i + step < count; i += all_pairs ? 1 : step) pairs.emplace_back(i, i + step);
  return pairs;
}

/// Path length from the first pose to each pose, metres.
std::vector<double> pathLengths(const Trajectory& poses) {
  std::vector<double> lengths(poses.size(), 0.0);
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const Vec3 step = poses[i].T_world_cam.translation() - poses[i - 1].T_world_cam.translation();
    lengths[i] = lengths[i - 1] + step.norm();
  }
  return lengths;
}

/// The path is cut as soon as a piece is long enough. The first pose is no end point: the first
/// piece only finds the first cut.
Pairs consecutiveByPath(const std::vector<double>& lengths, double delta) {
  Pairs pairs;
  int previous = -1;
  double start = 0;
  for (int i = 0; i < static_cast<int>(lengths.size()); ++i) {
    if (lengths[i] - start < delta) continue;
    if (previous >= 0) pairs.emplace_back(previous, i);
    previous = i;
    start = lengths[i];
  }
  return pairs;
}

/// The later index whose coordinate is nearest to `target`, or -1 if further than `tolerance`.
int laterNearest(const std::vector<double>& increasing, int i, double target, double tolerance) {
  const auto begin = increasing.begin() + i + 1;
  auto best = std::lower_bound(begin, increasing.end(), target);
  if (best != begin && (best == increasing.end() || target - *(best - 1) <= *best - target)) --best;
  if (best == increasing.end() || std::abs(*best - target) > tolerance) return -1;
  return static_cast<int>(best - increasing.begin());
}

/// Pairs along an increasing coordinate (time, path); without `all_pairs` a pair starts where the
/// previous one ended, or at the next pose if none ends at the interval (a gap).
Pairs alongCoordinate(const std::vector<double>& increasing, double delta, double tolerance,
                      bool all_pairs) {
  Pairs pairs;
  for (int i = 0; i < static_cast<int>(increasing.size());) {
    const int j = laterNearest(increasing, i, increasing[i] + delta, tolerance);
    if (j >= 0) pairs.emplace_back(i, j);
    i = j >= 0 && !all_pairs ? j : i + 1;
  }
  return pairs;
}

std::vector<double> times(const Trajectory& poses) {
  std::vector<double> result;
  for (const StampedPose& pose : poses) result.push_back(pose.timestamp);
  return result;
}

}  // namespace

std::string Delta::text() const {
  const char* suffix = unit == Unit::frames ? "f" : unit == Unit::seconds ? "s" : "m";
  return fmt::format("{:g}{}", value, suffix);
}

Result<Delta> parseDelta(const std::string& text) {
  const auto wrong = [&](const char* what) {
    return usageError(fmt::format("'{}' {}", text, what), "--delta",
                      "a positive number with its unit: 1s, 30f (frames) or 10m");
  };
  if (text.size() < 2) return wrong("is not an interval");
  Delta delta;
  switch (text.back()) {
    case 's':
      delta.unit = Delta::Unit::seconds;
      break;
    case 'f':
      delta.unit = Delta::Unit::frames;
      break;
    case 'm':
      delta.unit = Delta::Unit::metres;
      break;
    default:
      return wrong("has no known unit");
  }
  const char* end = text.data() + text.size() - 1;
  const auto parsed = std::from_chars(text.data(), end, delta.value);
  if (parsed.ec != std::errc() || parsed.ptr != end) return wrong("is not an interval");
  if (!(delta.value > 0) || !(delta.value < 1e9)) return wrong("is out of range");
  if (delta.unit == Delta::Unit::frames && delta.value != std::floor(delta.value)) {
    return wrong("is not a whole number of frames");
  }
  return delta;
}

std::vector<std::pair<int, int>> pairsApart(const Trajectory& poses, const Delta& delta,
                                            bool all_pairs) {
  const double relative = kRelativeTolerance * delta.value;
  switch (delta.unit) {
    case Delta::Unit::frames:
      return byFrames(static_cast<int>(poses.size()), static_cast<int>(delta.value), all_pairs);
    case Delta::Unit::seconds:
      return alongCoordinate(times(poses), delta.value, std::max(relative, kTimeTolerance),
                             all_pairs);
    case Delta::Unit::metres:
      if (!all_pairs) return consecutiveByPath(pathLengths(poses), delta.value);
      return alongCoordinate(pathLengths(poses), delta.value, relative, true);
  }
  return {};
}

}  // namespace svoscope
