// SPDX-License-Identifier: MIT
#include "engine/bench/yaml_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "engine/base/text_rows.h"

namespace svoscope {

void YamlReader::fail(const YAML::Node& node, const std::string& what,
                      const std::string& remedy) const {
  const int line = node.IsDefined() ? node.Mark().line + 1 : 0;
  throw YamlFault{inputError(what, line > 0 ? place(file_, line) : file_.string(), remedy)};
}

void YamlReader::requireKeys(const YAML::Node& node, const std::vector<std::string>& known,
                             const std::string& what) const {
  std::string list;
  for (const std::string& key : known) list += (list.empty() ? "" : ", ") + key;
  if (!node.IsMap()) fail(node, what + " is not a map", "known keys are " + list);
  for (const auto& entry : node) {
    const auto key = entry.first.as<std::string>();
    if (std::find(known.begin(), known.end(), key) == known.end())
      fail(entry.first, fmt::format("unknown key '{}' of {}", key, what), "known are " + list);
  }
}

std::string YamlReader::text(const YAML::Node& node, const std::string& what) const {
  if (!node.IsScalar()) fail(node, what + " is not a text", "give one value");
  return expanded(node, node.as<std::string>());
}

double YamlReader::number(const YAML::Node& node, const std::string& what, double low,
                          double high) const {
  const auto value = parseNumber(text(node, what));
  if (!value || !(*value >= low && *value <= high))
    fail(
        node,
        fmt::format("{} '{}' is not a number from {:g} to {:g}", what, text(node, what), low, high),
        "");
  return *value;
}

int YamlReader::integer(const YAML::Node& node, const std::string& what, int low, int high) const {
  const double value = number(node, what, low, high);
  if (value != std::floor(value))
    fail(node, fmt::format("{} '{}' is not a whole number", what, value), "");
  return static_cast<int>(value);
}

std::string YamlReader::expanded(const YAML::Node& node, const std::string& text) const {
  std::string result;
  std::size_t at = 0;
  while (true) {
    const std::size_t open = text.find("${", at);
    const std::size_t close = open == std::string::npos ? open : text.find('}', open);
    if (close == std::string::npos) return result + text.substr(at);
    const std::string name = text.substr(open + 2, close - open - 2);
    const char* value = std::getenv(name.c_str());
    if (!value && expand_)
      fail(node, fmt::format("the environment variable {} is not set", name),
           fmt::format("start with {}=VALUE svoscope bench ...", name));
    result += text.substr(at, open - at) + (value ? value : text.substr(open, close - open + 1));
    at = close + 1;
  }
}

}  // namespace svoscope
