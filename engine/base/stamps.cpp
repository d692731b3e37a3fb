// SPDX-License-Identifier: MIT
#include "engine/base/stamps.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "engine/base/quantile.h"
#include "engine/base/text_rows.h"

namespace svoscope {

namespace {

constexpr double kSmallestStamp = 1e9;  // 2001 in seconds; smaller numbers may be counters
constexpr double kLeastStep = 5e-4, kMostStep = 60;  // s, between two images
constexpr double kMostSparseStep = 1e4;              // s, between two keyframes

/// Length of the unit, s.
double lengthOf(StampUnit unit) {
  constexpr double kLengths[] = {1, 1e-3, 1e-6, 1e-9};
  return kLengths[static_cast<int>(unit)];
}

bool plausible(StampUnit unit, double step) {
  const double seconds = step * lengthOf(unit);
  return seconds >= kLeastStep && seconds <= kMostStep;
}

std::optional<std::int64_t> wholeNumber(const std::string& field) {
  std::int64_t value = 0;
  const char* end = field.data() + field.size();
  const auto [stop, error] = std::from_chars(field.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

/// Whole seconds and rest apart: 19 digits do not fit into a double.
double toSeconds(std::int64_t value, StampUnit unit) {
  constexpr std::int64_t kPerSecond[] = {1, 1000, 1000000, 1000000000};
  const std::int64_t base = kPerSecond[static_cast<int>(unit)];
  return static_cast<double>(value / base) + lengthOf(unit) * static_cast<double>(value % base);
}

}  // namespace

const char* stampUnitName(StampUnit unit) {
  constexpr const char* kNames[] = {"s", "ms", "us", "ns"};
  return kNames[static_cast<int>(unit)];
}

StampUnit stampUnit(double first, double median_step) {
  if (std::abs(first) < kSmallestStamp) return StampUnit::seconds;
  const double size = std::abs(first);
  const StampUnit since_1970 = size < 1e11   ? StampUnit::seconds
                               : size < 1e14 ? StampUnit::milliseconds
                               : size < 1e17 ? StampUnit::microseconds
                                             : StampUnit::nanoseconds;
  // Poses in seconds may be minutes apart; the other units are those of recorders.
  const bool far_apart = since_1970 != StampUnit::seconds || median_step > kMostSparseStep;
  if (!(median_step > 0) || !far_apart || plausible(since_1970, median_step)) return since_1970;
  // A clock that started with the machine: the step between images tells.
  for (const StampUnit unit : {StampUnit::nanoseconds, StampUnit::microseconds,
                               StampUnit::milliseconds, StampUnit::seconds}) {
    if (plausible(unit, median_step)) return unit;
  }
  return since_1970;
}

double medianStep(const std::vector<double>& values) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < values.size(); ++i) steps.push_back(values[i] - values[i - 1]);
  return upperMedian(std::move(steps));
}

std::optional<Stamps> readStamps(const std::vector<std::string>& fields, std::size_t* bad) {
  std::vector<double> rough;
  bool whole = true;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const auto value = parseNumber(fields[i]);
    if (!value || !std::isfinite(*value)) {
      if (bad) *bad = i;
      return std::nullopt;
    }
    rough.push_back(*value);
    whole = whole && wholeNumber(fields[i]).has_value();
  }
  Stamps stamps;
  stamps.seconds = rough;
  if (rough.empty()) return stamps;
  stamps.unit = stampUnit(rough.front(), medianStep(rough));
  if (stamps.unit == StampUnit::seconds) return stamps;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    stamps.seconds[i] =
        whole ? toSeconds(*wholeNumber(fields[i]), stamps.unit) : rough[i] * lengthOf(stamps.unit);
  }
  return stamps;
}

std::optional<Stamps> stampsOfNames(const std::vector<std::string>& stems) {
  if (stems.empty()) return std::nullopt;
  auto stamps = readStamps(stems);
  if (!stamps) return std::nullopt;
  for (const std::string& stem : stems) {
    if (*parseNumber(stem) < kSmallestStamp) return std::nullopt;
  }
  const auto& s = stamps->seconds;
  const bool increasing = std::adjacent_find(s.begin(), s.end(), std::greater_equal<>()) == s.end();
  return increasing ? stamps : std::nullopt;
}

}  // namespace svoscope
