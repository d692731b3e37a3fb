// SPDX-License-Identifier: MIT
#include "ui/widgets/controls.h"

#include <imgui/imgui_stdlib.h>

#include <cmath>
#include <cstdarg>
#include <cstdio>

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
  const bool entered =
      ImGui::InputInt(label, &value, 0, 0, ImGuiInputTextFlags_EnterReturnsTrue);
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

void valueRow(const char* name, const std::string& value, ImU32 color) {
  const float start = ImGui::GetCursorPosX();
  ImGui::PushStyleColor(ImGuiCol_Text, toVec4(ink::dim));
  ImGui::TextUnformatted(name);
  pen::itemText(ink::dim, name);
  ImGui::PopStyleColor();
  const float column = start + ImGui::GetFontSize() * 9.5f;
  const float value_x = std::max(column, start + ImGui::GetItemRectSize().x + grid(2));
  ImGui::SameLine(0, 0);
  ImGui::SetCursorPosX(value_x);  // unlike SameLine(x), right in table columns, too
  float room = ImGui::GetContentRegionAvail().x;
  if (room < ImGui::GetFontSize() * 7 && ImGui::CalcTextSize(value.c_str()).x > room) {  // below the name
    ImGui::NewLine();
    ImGui::SetCursorPosX(start + grid(3));
    room = ImGui::GetContentRegionAvail().x;
  }
  if (color) ImGui::PushStyleColor(ImGuiCol_Text, toVec4(color));
  const std::string shown = wrapped(value, room);
  ImGui::TextUnformatted(shown.c_str());
  pen::itemText(color ? color : ink::text, shown.c_str());
  if (color) ImGui::PopStyleColor();
}

void heading(const char* text) {
  ImGui::Dummy({0, grid(0.5f)});
  ImGui::TextUnformatted(text);
  pen::itemText(ink::text, text);
  const ImVec2 at = ImGui::GetItemRectMax();
  const float right = ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x;
  const float y = std::round((ImGui::GetItemRectMin().y + at.y) / 2);
  if (right > at.x + grid(2)) {
    pen::line(ImGui::GetWindowDrawList(), {at.x + grid(2), y}, {right, y}, ink::line);
  }
}

void note(const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, toVec4(ink::dim));
  const std::string shown = wrapped(text, ImGui::GetContentRegionAvail().x);
  ImGui::TextUnformatted(shown.c_str());
  pen::itemText(ink::dim, shown.c_str());
  ImGui::PopStyleColor();
}

std::string wrapped(const std::string& text, float width) {
  std::string result = text;
  std::size_t line = 0;
  for (std::size_t blank = text.find(' '); blank != std::string::npos;) {
    const std::size_t next = text.find(' ', blank + 1);
    const std::size_t end = next == std::string::npos ? text.size() : next;
    if (ImGui::CalcTextSize(text.data() + line, text.data() + end).x > width) {
      result[blank] = '\n';
      line = blank + 1;
    }
    blank = next;
  }
  return result;
}

void emptyState(const char* title, const std::string& what_to_do) {
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float width = std::min(room.x, ImGui::GetFontSize() * 36);
  if (width < 1) return;
  const ImVec2 title_size = ImGui::CalcTextSize(title, nullptr, false, width);
  const ImVec2 text_size = ImGui::CalcTextSize(what_to_do.c_str(), nullptr, false, width);
  const float height = title_size.y + text_size.y + grid(1);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float cx = at.x + room.x / 2;
  const float y = at.y + std::max(0.0f, (room.y - height) * 0.42f);
  ImDrawList* list = ImGui::GetWindowDrawList();
  ImFont* font = ImGui::GetFont();
  const float size = ImGui::GetFontSize();
  list->AddText(font, size, {std::round(cx - title_size.x / 2), std::round(y)}, ink::text, title,
                nullptr, width);
  list->AddText(font, size,
                {std::round(cx - text_size.x / 2), std::round(y + title_size.y + grid(1))},
                ink::dim, what_to_do.c_str(), nullptr, width);
}

float legendWidth(const char* text) {
  return ImGui::GetFontSize() + ImGui::CalcTextSize(text).x;
}

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

std::string format(const char* pattern, ...) {
  va_list args, again;
  va_start(args, pattern);
  va_copy(again, args);
  const int length = std::vsnprintf(nullptr, 0, pattern, args);
  va_end(args);
  std::string text(static_cast<std::size_t>(std::max(0, length)), '\0');
  std::vsnprintf(text.data(), text.size() + 1, pattern, again);
  va_end(again);
  return text;
}

}  // namespace svoscope::ui
