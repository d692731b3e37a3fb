// SPDX-License-Identifier: MIT
// Fields of comma-separated files.
#pragma once

#include <optional>
#include <string>

namespace svoscope {

/// Six digits; a value that does not exist is an empty field.
std::string csvNumber(const std::optional<double>& value);

/// In quotes, whatever is in it.
std::string csvQuoted(const std::string& text);

/// In quotes if a comma, a quote or a line end is in it.
std::string csvText(const std::string& text);

}  // namespace svoscope
