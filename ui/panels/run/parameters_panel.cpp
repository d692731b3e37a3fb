// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdlib>

#include "ui/palette.h"
#include "ui/panels/panel.h"
#include "ui/panels/panel_context.h"
#include "ui/panels/run/run_options.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/probe.h"

namespace svoscope::ui {

namespace {

constexpr const char* kReadOnly = "Read only: a recording shows what was computed";

void set(PanelContext& c, const std::string& key, const std::string& value) {
  Command command;
  command.kind = Command::Kind::set_parameter;
  command.key = key;
  command.value = value;
  c.runner.send(command);
}

bool editChoice(const ParameterView& p, std::string& value) {
  bool changed = false;
  if (ImGui::BeginCombo("##value", p.value.c_str())) {
    for (const std::string& choice : p.choices) {
      if (!ImGui::Selectable(choice.c_str(), choice == p.value)) continue;
      value = choice;
      changed = true;
    }
    ImGui::EndCombo();
  }
  return changed;
}

// Numbers are sent when the edit is finished, not with every digit typed.
bool editNumber(const ParameterView& p, std::string& value) {
  if (p.type == "int") {
    int v = std::atoi(p.value.c_str());
    const bool entered = ImGui::InputInt("##value", &v, 0, 0, ImGuiInputTextFlags_EnterReturnsTrue);
    if (p.maximum > p.minimum)
      v = std::clamp(v, static_cast<int>(p.minimum), static_cast<int>(p.maximum));
    value = std::to_string(v);
    return entered;
  }
  double v = std::atof(p.value.c_str());
  const bool entered =
      ImGui::InputDouble("##value", &v, 0, 0, "%.6g", ImGuiInputTextFlags_EnterReturnsTrue);
  if (p.maximum > p.minimum) v = std::clamp(v, p.minimum, p.maximum);
  value = format("%.9g", v);
  return entered;
}

bool edit(const ParameterView& p, std::string& value) {
  if (p.type == "bool") {
    bool on = p.value == "true" || p.value == "1";
    const bool changed = ImGui::Checkbox("##value", &on);
    value = on ? "true" : "false";
    return changed;
  }
  ImGui::SetNextItemWidth(-1);
  return p.type == "choice" ? editChoice(p, value) : editNumber(p, value);
}

std::string meaningOf(const ParameterView& p) {
  std::string text = p.key + "\n" + p.meaning + "\nDefault " + p.default_value +
                     (p.unit.empty() ? "" : " " + p.unit);
  if (p.maximum > p.minimum) text += format("\nFrom %g to %g", p.minimum, p.maximum);
  if (p.needs_reset) text += "\nTakes effect after a reset";
  return text;
}

std::string shortName(const ParameterView& p) { return p.key.substr(p.key.find('.') + 1); }

// Columns as wide as their longest text, the same in all groups: what is left is for the
// descriptions.
struct Columns {
  float name = 0, value = 0, unit = 0, reset = 0;
  bool described = true;  ///< else the descriptions are in the tooltips only
};

Columns columnsFor(const std::vector<ParameterView>& parameters, bool recorded) {
  Columns columns;
  columns.value = ImGui::GetFontSize() * 5;
  for (const ParameterView& p : parameters) {
    columns.name = std::max(columns.name, ImGui::CalcTextSize(shortName(p).c_str()).x);
    columns.unit = std::max(columns.unit, ImGui::CalcTextSize(p.unit.c_str()).x);
    if (p.value != p.default_value && !recorded) columns.reset = buttonWidth("Default");
  }
  const float room = ImGui::GetContentRegionAvail().x, pad = 2 * ImGui::GetStyle().CellPadding.x;
  const float others = columns.value + columns.unit + columns.reset + 4 * pad + grid(1);
  columns.described = room - columns.name - others - pad > ImGui::GetFontSize() * 6;
  if (!columns.described) columns.name = std::max(1.0f, std::min(columns.name, room - others));
  return columns;
}

void describe(const PanelContext& c, const ParameterView& p) {
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  if (p.needs_reset && !c.status.recorded) {
    ImGui::TextColored(toVec4(okabe::orange), "needs reset");
    ImGui::SameLine();
  }
  elidedText(p.meaning, ink::dim);
}

void row(PanelContext& c, const ParameterView& p, bool described) {
  const bool changed = p.value != p.default_value;
  ImGui::PushID(p.key.c_str());
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, toVec4(changed ? ink::text : ink::dim));
  ImGui::TextUnformatted(elided(shortName(p), ImGui::GetContentRegionAvail().x).c_str());
  ImGui::PopStyleColor();
  tooltip(meaningOf(p).c_str());
  ImGui::TableNextColumn();
  std::string value;
  if (c.status.recorded)
    ImGui::TextUnformatted(p.value.c_str());
  else if (edit(p, value) && value != p.value)
    set(c, p.key, value);
  Probe::record(p.key, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  tooltip(meaningOf(p).c_str());
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", p.unit.c_str());
  ImGui::TableNextColumn();
  if (changed && !c.status.recorded) {
    if (ImGui::SmallButton("Default")) set(c, p.key, p.default_value);
    Probe::record("Default " + p.key, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  }
  if (described) describe(c, p);
  ImGui::PopID();
}

bool beginGroup(const std::string& group, const Columns& columns) {
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit;
  heading(group.c_str());
  if (!ImGui::BeginTable(("##" + group).c_str(), columns.described ? 5 : 4, kFlags)) return false;
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, columns.name + grid(1));
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthFixed, columns.value);
  ImGui::TableSetupColumn("unit", ImGuiTableColumnFlags_WidthFixed, columns.unit);
  ImGui::TableSetupColumn("default", ImGuiTableColumnFlags_WidthFixed, columns.reset);
  if (columns.described) ImGui::TableSetupColumn("note", ImGuiTableColumnFlags_WidthStretch);
  return true;
}

void draw(PanelContext& c) {
  const auto parameters = c.run.parameters();
  if (parameters.empty()) return emptyState("No parameters", "This recording holds none");
  inputText("##parameter_filter", "Filter, for example reproject",
            c.options<ParametersOptions>().filter, ImGui::GetFontSize() * 14);
  if (c.status.recorded) {
    sameLineIfFits(ImGui::CalcTextSize(kReadOnly).x);
    ImGui::TextColored(toVec4(okabe::orange), "%s", kReadOnly);
    Probe::record("read only", ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  }
  const Columns columns = columnsFor(parameters, c.status.recorded);
  std::string group;
  bool open = false;
  int hidden = 0;
  for (const ParameterView& p : parameters) {
    const std::string& filter = c.options<ParametersOptions>().filter;
    if (p.key.find(filter) == std::string::npos && p.meaning.find(filter) == std::string::npos) {
      ++hidden;
      continue;
    }
    const std::size_t dot = p.key.find('.');
    const std::string prefix = dot == std::string::npos ? "general" : p.key.substr(0, dot);
    if (prefix != group) {
      if (open) ImGui::EndTable();
      open = beginGroup(prefix, columns);
      group = prefix;
    }
    if (open) row(c, p, columns.described);
  }
  if (open) ImGui::EndTable();
  if (hidden > 0) ImGui::TextColored(toVec4(okabe::orange), "%d hidden by the filter", hidden);
}

}  // namespace

extern const Panel kParametersPanel{"Parameters",        draw,
                                    /*csv=*/nullptr,
                                    /*charts=*/false,
                                    /*options=*/nullptr,
                                    /*exportable=*/false};

}  // namespace svoscope::ui
