// SPDX-License-Identifier: MIT
// Small helpers of the two-view start.
#pragma once

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace svoscope {

/// Upper median; 0 of nothing.
inline double medianOf(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// printf into a string; for one-line reasons.
template <typename... Args>
std::string formatLine(const char* text, Args... args) {
  char buffer[200];
  std::snprintf(buffer, sizeof buffer, text, args...);
  return buffer;
}

}  // namespace svoscope
