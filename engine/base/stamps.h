// SPDX-License-Identifier: MIT
// Time stamps as people have them: seconds with a fraction, or whole milli-, micro- or nanoseconds.
// One reader for lists of images, file names and trajectories.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace svoscope {

enum class StampUnit : std::uint8_t { seconds, milliseconds, microseconds, nanoseconds };
const char* stampUnitName(StampUnit unit);

/// Unit of increasing whole numbers, from `first` and the median step between them: since 1970 if
/// that gives a step between a 2000th of a second and a minute, else whatever does. Numbers below
/// 1e9 are seconds: nothing tells them from others.
StampUnit stampUnit(double first, double median_step);

/// Median step between numbers that follow one another; 0 with fewer than two.
double medianStep(const std::vector<double>& values);

struct Stamps {
  std::vector<double> seconds;
  StampUnit unit = StampUnit::seconds;
};

/// The fields of a list, all in the same unit, to the last nanosecond of their digits. `bad` (if
/// given) is the position of the first field that is no finite number; nothing is returned then.
std::optional<Stamps> readStamps(const std::vector<std::string>& fields,
                                 std::size_t* bad = nullptr);

/// Stamps of file names without extension: all of them numbers from 1e9 on, strictly increasing.
/// Empty if they are not.
std::optional<Stamps> stampsOfNames(const std::vector<std::string>& stems);

}  // namespace svoscope
