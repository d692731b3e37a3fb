// SPDX-License-Identifier: MIT
#include "engine/base/text_rows.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <fstream>

namespace svoscope {
namespace {

bool separates(char c) { return c == ' ' || c == '\t' || c == ',' || c == '\r'; }

std::vector<std::string> splitFields(const std::string& text) {
  std::vector<std::string> fields;
  size_t i = 0;
  while (i < text.size()) {
    while (i < text.size() && separates(text[i])) ++i;
    const size_t begin = i;
    while (i < text.size() && !separates(text[i])) ++i;
    if (i > begin) fields.push_back(text.substr(begin, i - begin));
  }
  return fields;
}

}  // namespace

std::string place(const std::filesystem::path& file, int line) {
  return file.string() + ":" + std::to_string(line);
}

Result<std::vector<TextRow>> readTextRows(const std::filesystem::path& file,
                                          const std::string& layout) {
  std::error_code ec;
  if (!std::filesystem::exists(file, ec))
    return inputError(file.filename().string() + " is missing", file.string(), layout);
  std::ifstream in(file);
  if (!in || std::filesystem::is_directory(file, ec))
    return inputError("the file cannot be read", file.string(), layout);
  std::vector<TextRow> rows;
  std::string text;
  for (int line = 1; std::getline(in, text); ++line) {
    if (line == 1 && text.rfind("\xEF\xBB\xBF", 0) == 0) text.erase(0, 3);  // UTF-8 mark
    const size_t comment = text.find('#');
    if (comment != std::string::npos) text.resize(comment);
    TextRow row{line, splitFields(text)};
    if (!row.fields.empty()) rows.push_back(std::move(row));
  }
  return rows;
}

std::optional<double> parseNumber(const std::string& field) {
  const char* begin = field.data();
  const char* end = begin + field.size();
  if (begin != end && *begin == '+') ++begin;
  double value = 0;
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

std::optional<double> parseNanoseconds(const std::string& field) {
  std::int64_t ns = 0;
  const char* end = field.data() + field.size();
  const auto [stop, error] = std::from_chars(field.data(), end, ns);
  if (error != std::errc() || stop != end) return std::nullopt;
  // Whole seconds and rest apart: 19 digits do not fit into a double.
  const std::int64_t giga = 1000000000;
  return static_cast<double>(ns / giga) + 1e-9 * static_cast<double>(ns % giga);
}

Result<std::vector<double>> finiteNumbers(const TextRow& row, size_t first, size_t count,
                                          const std::filesystem::path& file,
                                          const std::string& layout) {
  if (row.fields.size() < first + count)
    return inputError(
        std::to_string(row.fields.size()) + " fields instead of " + std::to_string(first + count),
        place(file, row.line), layout);
  std::vector<double> numbers;
  numbers.reserve(count);
  for (size_t i = first; i < first + count; ++i) {
    const auto value = parseNumber(row.fields[i]);
    if (!value || !std::isfinite(*value))
      return inputError("'" + row.fields[i] + "' is not a finite number", place(file, row.line),
                        layout);
    numbers.push_back(*value);
  }
  return numbers;
}

}  // namespace svoscope
