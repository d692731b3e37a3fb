// SPDX-License-Identifier: MIT
// Small random generator whose values are the same on every platform and library.
#pragma once

#include <cstdint>

namespace svoscope::synthetic {

/// Mixes two numbers into one seed (splitmix64).
inline std::uint64_t mixSeed(std::uint64_t a, std::uint64_t b) {
  std::uint64_t z = a + 0x9E3779B97F4A7C15ull * (b + 1);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
  return z ^ (z >> 31);
}

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() { return mixSeed(state_, ++count_); }
  /// Uniform in [low, high).
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(next() >> 11) * (1.0 / 9007199254740992.0);
  }
  /// Uniform in 0 .. n - 1.
  int below(int n) { return static_cast<int>(next() % static_cast<std::uint64_t>(n)); }

 private:
  std::uint64_t state_, count_ = 0;
};

}  // namespace svoscope::synthetic
