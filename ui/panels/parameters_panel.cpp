// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdlib>

#include "ui/palette.h"
#include "ui/panels/panel_context.h"
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
    if (p.maximum > p.minimum) v = std::clamp(v, static_cast<int>(p.minimum), static_cast<int>(p.maximum));
    value = std::to_string(v);
    return entered;
  }
  double v = std::atof(p.value.c_str());
  const bool entered = ImGui::InputDouble("##value", &v, 0, 0, "%.6g", ImGuiInputTextFlags_EnterReturnsTrue);
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
  std::string text = p.meaning + "\nDefault " + p.default_value + (p.unit.empty() ? "" : " " + p.unit);
  if (p.maximum > p.minimum) text += format("\nFrom %g to %g", p.minimum, p.maximum);
  if (p.needs_reset) text += "\nTakes effect after a reset";
  return text;
}

void row(PanelContext& c, const ParameterView& p, const std::string& short_name) {
  const bool changed = p.value != p.default_value;
  ImGui::PushID(p.key.c_str());
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, toVec4(changed ? ink::text : ink::dim));
  ImGui::TextUnformatted(short_name.c_str());
  ImGui::PopStyleColor();
  tooltip(meaningOf(p).c_str());
  ImGui::TableNextColumn();
  std::string value;
  if (c.status.recorded) ImGui::TextUnformatted(p.value.c_str());
  else if (edit(p, value) && value != p.value) set(c, p.key, value);
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
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  if (p.needs_reset && !c.status.recorded) {
    ImGui::TextColored(toVec4(okabe::orange), "needs reset");
    ImGui::SameLine();
  }
  ImGui::TextColored(toVec4(ink::faint), "%s", p.meaning.c_str());
  ImGui::PopID();
}

bool beginGroup(const std::string& group) {
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit;
  heading(group.c_str());
  if (!ImGui::BeginTable(("##" + group).c_str(), 5, kFlags)) return false;
  const float em = ImGui::GetFontSize();
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, em * 9);
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthFixed, em * 6);
  ImGui::TableSetupColumn("unit", ImGuiTableColumnFlags_WidthFixed, em * 2.5f);
  ImGui::TableSetupColumn("default", ImGuiTableColumnFlags_WidthFixed, em * 4);
  ImGui::TableSetupColumn("note", ImGuiTableColumnFlags_WidthStretch);
  return true;
}

}  // namespace

void drawParametersPanel(PanelContext& c) {
  const auto parameters = c.runner.parameters();
  if (parameters.empty()) return emptyState("No parameters", "This recording holds none");
  inputText("##parameter_filter", "Filter, for example reproject", c.state.parameter_filter, ImGui::GetFontSize() * 14);
  if (c.status.recorded) {
    sameLineIfFits(ImGui::CalcTextSize(kReadOnly).x);
    ImGui::TextColored(toVec4(okabe::orange), "%s", kReadOnly);
    Probe::record("read only", ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  }
  std::string group;
  bool open = false;
  int hidden = 0;
  for (const ParameterView& p : parameters) {
    const std::string& filter = c.state.parameter_filter;
    if (p.key.find(filter) == std::string::npos && p.meaning.find(filter) == std::string::npos) {
      ++hidden;
      continue;
    }
    const std::size_t dot = p.key.find('.');
    const std::string prefix = dot == std::string::npos ? "general" : p.key.substr(0, dot);
    if (prefix != group) {
      if (open) ImGui::EndTable();
      open = beginGroup(prefix);
      group = prefix;
    }
    if (open) row(c, p, dot == std::string::npos ? p.key : p.key.substr(dot + 1));
  }
  if (open) ImGui::EndTable();
  if (hidden > 0) ImGui::TextColored(toVec4(okabe::orange), "%d hidden by the filter", hidden);
}

}  // namespace svoscope::ui
