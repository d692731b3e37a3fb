// SPDX-License-Identifier: MIT
#include "ui/harness/inspector_options.h"

#include <cstdlib>
#include <map>

#include "ui/panels/panel.h"

namespace svoscope::ui {
namespace {

PanelOption ofState(const char* name, bool UiState::*field) {
  return {name, [=](const UiState& s) { return s.*field ? 1.0 : 0.0; },
          [=](UiState& s, double v) { s.*field = v != 0; }};
}

PanelOption ofState(const char* name, int UiState::*field) {
  return {name, [=](const UiState& s) { return static_cast<double>(s.*field); },
          [=](UiState& s, double v) { s.*field = static_cast<int>(v); }};
}

std::map<std::string, PanelOption> collect() {
  std::map<std::string, PanelOption> all;
  const auto add = [&](const PanelOption& option) { all.emplace(option.name, option); };
  add(ofState("help", &UiState::show_help));
  add(ofState("align_mode", &UiState::align_mode));
  for (const Panel* panel : panels()) {
    if (!panel->options) continue;
    for (const PanelOption& option : panel->options()) add(option);
  }
  return all;
}

/// Those of the panels and of the window.
const std::map<std::string, PanelOption>& options() {
  static const std::map<std::string, PanelOption> all = collect();
  return all;
}

std::optional<double> asNumber(const std::string& text) {
  if (text == "on" || text == "true" || text == "yes") return 1;
  if (text == "off" || text == "false" || text == "no") return 0;
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0') return std::nullopt;
  return value;
}

}  // namespace

Status setOption(UiState& state, const std::string& name, const std::string& value) {
  const auto option = options().find(name);
  if (option == options().end()) {
    std::string known;
    for (const auto& [key, unused] : options()) known += (known.empty() ? "" : ", ") + key;
    return usageError("no parameter or option is called '" + name + "'", "",
                      "options: " + known + "; parameters: those of the panel Parameters");
  }
  const std::optional<double> number = asNumber(value);
  if (!number) return usageError("'" + value + "' is neither a number nor on or off", "", "");
  option->second.set(state, *number);
  return Done{};
}

std::optional<ScriptValue> optionValue(const UiState& state, const std::string& name) {
  const auto option = options().find(name);
  if (option == options().end()) return std::nullopt;
  return ScriptValue(option->second.get(state));
}

}  // namespace svoscope::ui
