// SPDX-License-Identifier: MIT
#include "engine/io/csv.h"

#include <fmt/format.h>

namespace svoscope {

std::string csvNumber(const std::optional<double>& value) {
  return value ? fmt::format("{:.6g}", *value) : "";
}

std::string csvQuoted(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string csvText(const std::string& text) {
  return text.find_first_of(",\"\n") == std::string::npos ? text : csvQuoted(text);
}

}  // namespace svoscope
