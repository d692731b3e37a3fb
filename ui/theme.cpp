// SPDX-License-Identifier: MIT
#include "ui/theme.h"

#include <imgui/imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/palette.h"

namespace svoscope::ui {

namespace {

float g_scale = 1;

void setColors(ImVec4* c) {
  const auto set = [c](int slot, ImU32 color) { c[slot] = toVec4(color); };
  set(ImGuiCol_Text, ink::text);
  set(ImGuiCol_TextDisabled, ink::dim);
  set(ImGuiCol_WindowBg, ink::window);
  set(ImGuiCol_ChildBg, IM_COL32(0, 0, 0, 0));
  set(ImGuiCol_PopupBg, IM_COL32(30, 34, 40, 250));
  set(ImGuiCol_Border, ink::line);
  set(ImGuiCol_FrameBg, IM_COL32(40, 45, 53, 255));
  set(ImGuiCol_FrameBgHovered, IM_COL32(50, 57, 67, 255));
  set(ImGuiCol_FrameBgActive, IM_COL32(58, 67, 79, 255));
  set(ImGuiCol_MenuBarBg, ink::title);
  set(ImGuiCol_TitleBg, ink::title);
  set(ImGuiCol_TitleBgActive, ink::title);
  set(ImGuiCol_Button, IM_COL32(45, 51, 60, 255));
  set(ImGuiCol_ButtonHovered, IM_COL32(58, 66, 78, 255));
  set(ImGuiCol_ButtonActive, IM_COL32(70, 82, 98, 255));
  set(ImGuiCol_Header, IM_COL32(45, 58, 72, 255));
  set(ImGuiCol_HeaderHovered, IM_COL32(52, 68, 85, 255));
  set(ImGuiCol_HeaderActive, IM_COL32(60, 80, 100, 255));
  set(ImGuiCol_CheckMark, ink::accent);
  set(ImGuiCol_SliderGrab, withAlpha(ink::accent, 0.4f));  // the value is written over it
  set(ImGuiCol_SliderGrabActive, withAlpha(ink::accent, 0.55f));
  set(ImGuiCol_Separator, ink::line);
  set(ImGuiCol_ScrollbarBg, IM_COL32(0, 0, 0, 0));
  set(ImGuiCol_ScrollbarGrab, IM_COL32(62, 69, 80, 255));
  set(ImGuiCol_ScrollbarGrabHovered, IM_COL32(80, 89, 102, 255));
  set(ImGuiCol_ScrollbarGrabActive, IM_COL32(96, 106, 121, 255));
  set(ImGuiCol_TextSelectedBg, withAlpha(ink::accent, 0.35f));
  set(ImGuiCol_NavHighlight, ink::accent);
  set(ImGuiCol_TableBorderLight, ink::grid);
  set(ImGuiCol_TableBorderStrong, ink::line);
  set(ImGuiCol_TableRowBgAlt, IM_COL32(255, 255, 255, 6));
  set(ImGuiCol_TableHeaderBg, ink::title);
}

}  // namespace

void applyTheme(float scale) {
  g_scale = std::clamp(scale, 0.75f, 3.0f);
  ImGuiStyle style;
  ImGui::StyleColorsDark(&style);
  setColors(style.Colors);
  style.WindowPadding = {8, 8};
  style.FramePadding = {8, 2};
  style.ItemSpacing = {8, 4};
  style.ItemInnerSpacing = {4, 4};
  style.CellPadding = {4, 2};
  style.IndentSpacing = 12;
  style.ScrollbarSize = 10;
  style.GrabMinSize = 8;
  style.WindowRounding = 0;
  style.ChildRounding = 0;
  style.FrameRounding = 3;
  style.PopupRounding = 4;
  style.GrabRounding = 3;
  style.ScrollbarRounding = 4;
  style.WindowBorderSize = 0;
  style.ChildBorderSize = 0;
  style.DisabledAlpha = 0.42f;
  style.ScaleAllSizes(g_scale);
  ImGui::GetStyle() = style;
}

float grid(float units) { return std::round(units * 4 * g_scale); }
float dp(float value) { return value * g_scale; }

}  // namespace svoscope::ui
