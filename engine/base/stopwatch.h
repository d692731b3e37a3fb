// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

namespace svoscope {

/// Wall-clock stopwatch, milliseconds.
class Stopwatch {
 public:
  Stopwatch() : start_(Clock::now()) {}
  double ms() const {
    return std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
  }
  /// Time since start or the last lap.
  double lapMs() {
    const auto now = Clock::now();
    const double ms = std::chrono::duration<double, std::milli>(now - start_).count();
    start_ = now;
    return ms;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_;
};

}  // namespace svoscope
