// SPDX-License-Identifier: MIT
#include "ui/harness/expectation.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace svoscope::ui {
namespace {

std::optional<double> asNumber(const std::string& text) {
  if (text == "true" || text == "yes" || text == "on") return 1;
  if (text == "false" || text == "no" || text == "off") return 0;
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0') return std::nullopt;
  return number;
}

template <typename T>
std::optional<bool> compare(const T& a, const std::string& op, const T& b) {
  if (op == "==") return a == b;
  if (op == "!=") return a != b;
  if (op == "<") return a < b;
  if (op == "<=") return a <= b;
  if (op == ">") return a > b;
  if (op == ">=") return a >= b;
  return std::nullopt;
}

std::optional<bool> holds(const ScriptValue& actual, const std::string& op,
                          const std::string& expected) {
  if (const auto* list = std::get_if<std::vector<std::string>>(&actual)) {
    const bool found = std::find(list->begin(), list->end(), expected) != list->end();
    if (op == "has") return found;
    if (op == "!has") return !found;
    return std::nullopt;
  }
  if (const auto* text = std::get_if<std::string>(&actual)) {
    if (op == "has") return text->find(expected) != std::string::npos;
    return compare(*text, op, expected);
  }
  const std::optional<double> number = asNumber(expected);
  if (!number) return std::nullopt;
  return compare(std::get<double>(actual), op, *number);
}

}  // namespace

std::string describe(const ScriptValue& value) {
  if (const auto* number = std::get_if<double>(&value)) {
    char text[40];
    std::snprintf(text, sizeof text, "%.9g", *number);
    return text;
  }
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  std::string list;
  for (const std::string& entry : std::get<std::vector<std::string>>(value))
    list += (list.empty() ? "" : ", ") + entry;
  return "[" + list + "]";
}

Status checkExpectation(const std::vector<std::string>& words, const ScriptValues& values) {
  if (words.size() < 3) return usageError("an expectation is NAME OP VALUE", "", "");
  const std::string &name = words[0], &op = words[1];
  std::string expected = words[2];
  for (std::size_t i = 3; i < words.size(); ++i) expected += " " + words[i];
  const std::optional<ScriptValue> actual = values(name);
  if (!actual) return usageError("nothing is called '" + name + "'", "", "");
  const std::optional<bool> result = holds(*actual, op, expected);
  if (!result) {
    return usageError("'" + op + "' does not compare " + name + " (" + describe(*actual) +
                          ") with " + expected,
                      "", "numbers and texts: == != < <= > >=; lists: has, !has");
  }
  if (*result) return Done{};
  return Error{ErrorKind::internal,
               "expected " + name + " " + op + " " + expected + ", but it is " + describe(*actual),
               "", ""};
}

}  // namespace svoscope::ui
