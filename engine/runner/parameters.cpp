// SPDX-License-Identifier: MIT
#include "engine/runner/parameters.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <type_traits>

#include "engine/runner/parameter_table.h"

namespace svoscope {

namespace {

template <typename T>
std::string textOf(const T& value) {
  if constexpr (std::is_same_v<T, bool>)
    return value ? "true" : "false";
  else
    return fmt::format("{}", value);
}

bool parse(const std::string& text, bool& value) {
  for (const char* yes : {"true", "on", "yes", "1"}) {
    if (text == yes) return value = true, true;
  }
  for (const char* no : {"false", "off", "no", "0"}) {
    if (text == no) return value = false, true;
  }
  return false;
}

template <typename T>
bool parse(const std::string& text, T& value) {
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stop == end && std::isfinite(static_cast<double>(value));
}

template <typename T>
constexpr const char* typeName() {
  if constexpr (std::is_same_v<T, bool>)
    return "bool";
  else if constexpr (std::is_integral_v<T>)
    return "int";
  else
    return "float";
}

std::string known(Parameters& parameters, const std::string& key) {
  // The keys of the same group help more than all of them.
  const std::string group = key.substr(0, key.find('.') + 1);
  std::string same, groups;
  visitParameters(parameters, [&](const ParameterInfo& info, auto&) {
    const std::string name = info.key;
    const std::string its_group = name.substr(0, name.find('.'));
    if (!group.empty() && name.rfind(group, 0) == 0) same += (same.empty() ? "" : ", ") + name;
    if (groups.find(its_group) == std::string::npos)
      groups += (groups.empty() ? "" : ", ") + its_group;
  });
  return same.empty() ? "groups are " + groups : "known are " + same;
}

bool hasParameter(Parameters& parameters, const std::string& key) {
  bool found = false;
  visitParameters(parameters,
                  [&](const ParameterInfo& info, auto&) { found = found || key == info.key; });
  return found;
}

template <typename T>
Status checkBounds(const ParameterInfo& info, const T& value) {
  const auto number = static_cast<double>(value);
  if (std::is_same_v<T, bool> || (number >= info.minimum && number <= info.maximum)) return Done{};
  return usageError(fmt::format("{} is out of bounds", textOf(value)), info.key,
                    fmt::format("allowed are {} to {} {}", info.minimum, info.maximum, info.unit));
}

/// A value of a configuration file: its errors are input errors that name the file.
Status setInFile(Parameters& parameters, const std::string& key, const YAML::Node& value,
                 const std::string& where) {
  const Status set = setParameter(parameters, key, value.as<std::string>());
  if (set.ok()) return set;
  Error error = set.error();
  error.kind = ErrorKind::input;
  error.where = where + ", " + error.where;
  return error;
}

}  // namespace

Status setParameter(Parameters& parameters, const std::string& key, const std::string& value) {
  std::optional<Status> outcome;
  visitParameters(parameters, [&](const ParameterInfo& info, auto& field) {
    if (key != info.key) return;
    auto parsed = field;
    const bool is_bool = std::is_same_v<std::decay_t<decltype(field)>, bool>;
    if (!parse(value, parsed)) {
      outcome = usageError(
          fmt::format("'{}' is not a valid {}", value, typeName<std::decay_t<decltype(field)>>()),
          key, is_bool ? "use true or false" : "use a number");
    } else if (Status inside = checkBounds(info, parsed); !inside.ok()) {
      outcome = std::move(inside);
    } else {
      field = parsed;
      outcome = Status(Done{});
    }
  });
  if (outcome) return *outcome;
  return usageError("unknown parameter", key, known(parameters, key));
}

Status checkParameters(const Parameters& parameters) {
  Status status = Done{};
  visitParameters(parameters, [&](const ParameterInfo& info, const auto& field) {
    if (status.ok()) status = checkBounds(info, field);
  });
  return status;
}

std::vector<ParameterView> listParameters(const Parameters& parameters) {
  std::vector<ParameterView> views;
  visitParameters(parameters, [&](const ParameterInfo& info, const auto& field) {
    ParameterView view;
    view.key = info.key;
    view.value = textOf(field);
    view.unit = info.unit;
    view.meaning = info.meaning;
    view.type = typeName<std::decay_t<decltype(field)>>();
    view.minimum = info.minimum;
    view.maximum = info.maximum;
    view.needs_reset = info.needs_reset;
    views.push_back(std::move(view));
  });
  const Parameters defaults;
  std::size_t i = 0;
  visitParameters(defaults, [&](const ParameterInfo&, const auto& field) {
    views[i++].default_value = textOf(field);
  });
  return views;
}

Status loadParameters(Parameters& parameters, const std::filesystem::path& file) {
  const std::string where = file.string();
  try {
    const YAML::Node root = YAML::LoadFile(where);
    if (!root.IsMap())
      return inputError("is not a map of parameter groups", where,
                        "write 'reproject:' and below it 'cell_px: 30'");
    for (const auto& group : root) {
      const auto name = group.first.as<std::string>();
      // What parametersYaml adds for the record.
      if (name == "method") continue;
      if (group.second.IsScalar() && hasParameter(parameters, name)) {
        if (const Status set = setInFile(parameters, name, group.second, where); !set.ok())
          return set;
        continue;
      }
      if (!group.second.IsMap())
        return inputError("group '" + name + "' is not a map", where, known(parameters, name));
      for (const auto& entry : group.second) {
        const std::string key = name + "." + entry.first.as<std::string>();
        if (const Status set = setInFile(parameters, key, entry.second, where); !set.ok())
          return set;
      }
    }
  } catch (const YAML::BadFile&) {
    return inputError("cannot be read", where, "check the path and its permissions");
  } catch (const YAML::Exception& e) {
    return inputError(e.what(), where, "write YAML groups such as 'reproject: {cell_px: 30}'");
  }
  return Done{};
}

std::string parametersYaml(const Parameters& parameters, const std::string& method) {
  std::string text = fmt::format("method: {}\n", method);
  // The table may come back to a group; YAML allows each key once.
  std::vector<std::pair<std::string, std::string>> groups;
  for (const ParameterView& view : listParameters(parameters)) {
    const auto dot = view.key.find('.');
    if (dot == std::string::npos) {
      text += fmt::format("{}: {}\n", view.key, view.value);
      continue;
    }
    const std::string name = view.key.substr(0, dot);
    auto group =
        std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.first == name; });
    if (group == groups.end()) group = groups.insert(groups.end(), {name, ""});
    group->second += fmt::format("  {}: {}\n", view.key.substr(dot + 1), view.value);
  }
  for (const auto& [name, lines] : groups) text += name + ":\n" + lines;
  return text;
}

}  // namespace svoscope
