// SPDX-License-Identifier: MIT
#include "ui/widgets/controls.h"

#include <imgui/imgui_stdlib.h>

#include "ui/palette.h"
#include "ui/theme.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/pen.h"
#include "ui/widgets/probe.h"

namespace svoscope::ui {

namespace {

struct Disabled {
  explicit Disabled(const ControlHint& hint) : on(hint.disabled_because != nullptr) {
    if (on) ImGui::BeginDisabled();
  }
  ~Disabled() {
    if (on) ImGui::EndDisabled();
  }
  Disabled(const Disabled&) = delete;
  bool on;
};

void hintTooltip(const ControlHint& hint) {
  tooltip(hint.disabled_because ? hint.disabled_because : hint.tooltip);
}

struct Lit {
  explicit Lit(bool lit) : on(lit) {
    if (!on) return;
    ImGui::PushStyleColor(ImGuiCol_Button, toVec4(withAlpha(ink::accent, 0.30f)));
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, toVec4(withAlpha(ink::accent, 0.42f)));
  }
  ~Lit() {
    if (on) ImGui::PopStyleColor(2);
  }
  Lit(const Lit&) = delete;
  bool on;
};

}  // namespace

bool button(const char* label, const ControlHint& hint, bool highlighted) {
  bool pressed = false;
  {
    const Disabled disabled(hint);
    const Lit lit(highlighted);
    pressed = ImGui::Button(label);
    Probe::record(label);
  }
  hintTooltip(hint);
  return pressed;
}

bool iconButton(const char* label, Icon icon, const ControlHint& hint, bool highlighted) {
  bool pressed = false;
  const float side = ImGui::GetFrameHeight();
  {
    const Disabled disabled(hint);
    const Lit lit(highlighted);
    ImGui::PushID(label);
    pressed = ImGui::Button("##icon", {side + grid(2), side});
    ImGui::PopID();
    Probe::record(label);
    const ImVec2 lo = ImGui::GetItemRectMin(), hi = ImGui::GetItemRectMax();
    drawIcon(icon, {(lo.x + hi.x) / 2, (lo.y + hi.y) / 2}, side * 0.30f,
             ImGui::GetColorU32(ImGuiCol_Text));
  }
  hintTooltip(hint);
  return pressed;
}

bool toggle(const char* label, bool& value, const char* text) {
  ImGui::PushStyleColor(ImGuiCol_Text, toVec4(value ? ink::text : ink::dim));
  bool pressed = false;
  {
    const Lit lit(value);
    pressed = ImGui::Button(label);
  }
  ImGui::PopStyleColor();
  Probe::record(label);
  tooltip(text);
  if (pressed) value = !value;
  return pressed;
}

bool checkbox(const char* label, bool& value, const char* text) {
  const bool changed = ImGui::Checkbox(label, &value);
  Probe::record(label);
  tooltip(text);
  return changed;
}

bool combo(const char* label, int& index, const std::vector<const char*>& items, float width,
           const char* text) {
  ImGui::SetNextItemWidth(width);
  const int count = static_cast<int>(items.size());
  bool changed = false;
  const bool open = ImGui::BeginCombo(label, index >= 0 && index < count ? items[index] : "");
  Probe::record(label[0] == '#' ? label + 2 : label);
  if (!open) tooltip(text);
  if (!open) return false;
  for (int i = 0; i < count; ++i) {
    if (ImGui::Selectable(items[i], i == index)) {
      changed = index != i;
      index = i;
    }
    Probe::record(items[i]);
  }
  ImGui::EndCombo();
  return changed;
}

bool slider(const char* label, float& value, float lo, float hi, const char* pattern, float width,
            const char* text) {
  ImGui::SetNextItemWidth(width);
  const bool changed = ImGui::SliderFloat(label, &value, lo, hi, pattern);
  Probe::record(label[0] == '#' ? label + 2 : label);
  tooltip(text);
  return changed;
}

bool inputText(const char* label, const char* hint, std::string& text, float width) {
  ImGui::SetNextItemWidth(width);
  const bool changed = ImGui::InputTextWithHint(label, hint, &text);
  Probe::record(label[0] == '#' ? label + 2 : label);
  return changed;
}

bool inputInt(const char* label, int& value, float width, const char* text) {
  ImGui::SetNextItemWidth(width);
  const bool entered = ImGui::InputInt(label, &value, 0, 0, ImGuiInputTextFlags_EnterReturnsTrue);
  Probe::record(label[0] == '#' ? label + 2 : label);
  tooltip(text);
  return entered;
}

void tooltip(const char* text) {
  if (!text || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24);
  ImGui::TextUnformatted(text);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void sameLineIfFits(float width) {
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  const float next = ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x;
  if (next + width <= right) ImGui::SameLine();
}

float buttonWidth(const char* label) {
  return ImGui::CalcTextSize(label, nullptr, true).x + 2 * ImGui::GetStyle().FramePadding.x;
}

bool shortOfRoom() {
  const ImVec2 room = ImGui::GetContentRegionAvail();
  return room.y < ImGui::GetFontSize() * 17;
}

OptionBar::OptionBar(bool compact) : compact_(compact) {
  if (!compact_) return;
  sameLineIfFits(buttonWidth("Show"));
  if (button("Show", {"What to show"})) ImGui::OpenPopup("##options");
  open_ = ImGui::BeginPopup("##options");
}

OptionBar::~OptionBar() {
  if (open_) ImGui::EndPopup();
}

void OptionBar::item(const char* label, bool& value, const char* hint) {
  if (compact_) {
    if (open_) checkbox(label, value, hint);
    return;
  }
  sameLineIfFits(buttonWidth(label));
  toggle(label, value, hint);
}

float legendWidth(const char* text) { return ImGui::GetFontSize() + ImGui::CalcTextSize(text).x; }

void legendEntry(ImU32 color, Swatch kind, const char* text) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float s = ImGui::GetFontSize();
  drawSwatch(kind, {at.x + s * 0.36f, at.y + ImGui::GetTextLineHeight() / 2}, s * 0.28f, color);
  ImGui::BeginGroup();
  ImGui::Dummy({s * 0.8f, ImGui::GetTextLineHeight()});
  ImGui::SameLine(0, s * 0.2f);
  ImGui::PushStyleColor(ImGuiCol_Text, toVec4(ink::dim));
  ImGui::TextUnformatted(text);
  pen::itemText(ink::dim, text);
  ImGui::PopStyleColor();
  ImGui::EndGroup();
}

}  // namespace svoscope::ui
