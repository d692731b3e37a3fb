// SPDX-License-Identifier: MIT
// Rows of a text file: fields separated by blanks or commas, '#' starts a comment.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace svoscope {

struct TextRow {
  int line = 0;  ///< line number in the file, from 1
  std::vector<std::string> fields;
};

/// All rows that are not blank or comments; line ends may be LF or CRLF. Input error if the file
/// cannot be read. `layout` becomes the remedy of that error: "a TUM folder needs ...".
Result<std::vector<TextRow>> readTextRows(const std::filesystem::path& file,
                                          const std::string& layout);

/// The whole field as a number, whatever the locale; empty if it is not one. NaN and infinity are
/// numbers here: whether they are allowed is the caller's decision.
std::optional<double> parseNumber(const std::string& field);

/// Seconds of an integer nanosecond stamp, rounded once; empty if the field is not an integer.
std::optional<double> parseNanoseconds(const std::string& field);

/// Fields [first, first + count) of a row as finite numbers. The error names file, line and field.
Result<std::vector<double>> finiteNumbers(const TextRow& row, size_t first, size_t count,
                                          const std::filesystem::path& file,
                                          const std::string& layout);

/// "file:line", the place an error concerns.
std::string place(const std::filesystem::path& file, int line);

}  // namespace svoscope
