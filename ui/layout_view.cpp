// SPDX-License-Identifier: MIT
#include "ui/layout_view.h"

#include <algorithm>
#include <cmath>

#include "ui/palette.h"
#include "ui/panels/panel.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/probe.h"
#include "ui/widgets/splitter.h"

namespace svoscope::ui {

namespace {

float titleHeight() { return std::round(ImGui::GetFontSize() + grid(2)); }

void toggleMaximized(LayoutView& view, const std::string& panel) {
  if (!view.maximized) return;
  *view.maximized = view.maximized->empty() ? panel : std::string();
}

float tabWidth(const std::string& name) { return ImGui::CalcTextSize(name.c_str()).x + grid(4); }

void tab(const std::string& name, ImVec2 at, float width, bool active, bool& clicked,
         bool& doubled) {
  const float height = titleHeight();
  ImGui::SetCursorScreenPos(at);
  clicked = ImGui::InvisibleButton(name.c_str(), {width, height});
  doubled = ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0);
  Probe::record("tab:" + name, {at.x, at.y}, {at.x + width, at.y + height});
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 hi{at.x + width, at.y + height};
  if (active) {
    list->AddRectFilled(at, hi, ink::panel);
    list->AddRectFilled(at, {hi.x, at.y + dp(2)}, ink::accent);
  }
  const ImU32 color = active ? ink::text : ImGui::IsItemHovered() ? ink::text : ink::dim;
  list->AddText({at.x + grid(2), std::round(at.y + (height - ImGui::GetFontSize()) / 2)}, color,
                elided(name, width - grid(4)).c_str());
  if (width < tabWidth(name)) tooltip(name.c_str());
}

// Label of the button: an arrow where the tabs need the room; empty if there is nothing to export.
std::string exportLabel(const std::string& panel, float room) {
  const Panel* found = findPanel(panel);
  if (!found || !found->exportable) return "";
  return tabWidth("Export") <= room ? "Export" : "↓";
}

// The tab in front keeps its width, the others share what is left.
std::vector<float> tabWidths(const LayoutNode& node, float room) {
  const auto active = static_cast<std::size_t>(node.active);
  const float front = std::min(tabWidth(node.panels[active]), std::max(1.0f, room));
  std::vector<float> widths;
  for (const std::string& name : node.panels) widths.push_back(tabWidth(name));
  widths[active] = 0;
  widths = sharedWidths(widths, room - front);
  widths[active] = front;
  return widths;
}

// At the right end; returns where the rest of the bar begins.
float exportButton(const std::string& panel, const std::string& label, float x, ImVec2 lo,
                   ImVec2& hi, LayoutView& view) {
  if (label.empty()) return x;
  const float width = tabWidth(label);
  const ImVec2 at{hi.x - width, lo.y};
  ImGui::SetCursorScreenPos(at);
  if (ImGui::InvisibleButton("##export", {width, titleHeight()})) view.export_clicked = panel;
  Probe::record("export:" + panel, at, {hi.x, lo.y + titleHeight()});
  const ImU32 color = ImGui::IsItemHovered() ? ink::text : ink::dim;
  ImGui::GetWindowDrawList()->AddText(
      {at.x + grid(2), std::round(lo.y + (titleHeight() - ImGui::GetFontSize()) / 2)}, color,
      label.c_str());
  if (label != "Export") tooltip("Export");
  hi.x = at.x;
  return x;
}

void titleBar(LayoutNode& node, ImVec2 lo, ImVec2 hi, LayoutView& view) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(lo, {hi.x, lo.y + titleHeight()}, ink::title);
  ImGui::PushClipRect(lo, {hi.x, lo.y + titleHeight()}, true);
  const std::string& active = node.panels[static_cast<std::size_t>(node.active)];
  float all = 0;
  for (const std::string& name : node.panels) all += tabWidth(name);
  const std::string label = exportLabel(active, hi.x - lo.x - all);
  const std::vector<float> widths =
      tabWidths(node, hi.x - lo.x - (label.empty() ? 0 : tabWidth(label)));
  float x = lo.x;
  for (int i = 0; i < static_cast<int>(node.panels.size()); ++i) {
    bool clicked = false, doubled = false;
    const std::string& name = node.panels[static_cast<std::size_t>(i)];
    const float width = std::max(1.0f, widths[static_cast<std::size_t>(i)]);
    tab(name, {x, lo.y}, width, i == node.active, clicked, doubled);
    x += width;
    if (clicked && node.active != i) {
      node.active = i;
      view.changed = true;
    }
    if (doubled) toggleMaximized(view, name);
  }
  x = exportButton(node.panels[static_cast<std::size_t>(node.active)], label, x, lo, hi, view);
  if (hi.x > x + 1) {
    ImGui::SetCursorScreenPos({x, lo.y});
    ImGui::InvisibleButton("##rest", {hi.x - x, titleHeight()});
    const bool doubled = ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0);
    if (doubled) toggleMaximized(view, node.panels[static_cast<std::size_t>(node.active)]);
  }
  ImGui::PopClipRect();
}

void drawLeaf(LayoutNode& node, ImVec2 lo, ImVec2 hi, LayoutView& view) {
  if (node.panels.empty() || hi.x - lo.x < 8 || hi.y - lo.y < 8) return;
  node.active = std::clamp(node.active, 0, static_cast<int>(node.panels.size()) - 1);
  const std::string panel = node.panels[static_cast<std::size_t>(node.active)];
  ImGui::PushID(node.panels.front().c_str());
  titleBar(node, lo, hi, view);
  const ImVec2 top{lo.x, lo.y + titleHeight()};
  ImGui::GetWindowDrawList()->AddRectFilled(top, hi, ink::panel);
  ImGui::SetCursorScreenPos(top);
  // Pictures are zoomed by the wheel; the lists below scroll.
  const bool picture = panel == "Image" || panel == "3-D" || panel == "Plots" ||
                       panel == "Compare images" || panel == "Compare 3-D" ||
                       panel == "Compare plots";
  const ImGuiWindowFlags flags =
      ImGuiWindowFlags_AlwaysUseWindowPadding | (picture ? ImGuiWindowFlags_NoScrollWithMouse : 0);
  const ImVec2 size{std::max(1.0f, hi.x - lo.x), std::max(1.0f, hi.y - top.y)};
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {grid(1.5f), grid(1.5f)});
  if (ImGui::BeginChild(panel.c_str(), size, false, flags)) view.draw_panel(panel);
  ImGui::EndChild();
  ImGui::PopStyleVar();
  Probe::record("panel:" + panel, lo, hi);
  ImGui::PopID();
}

void drawNode(LayoutNode& node, ImVec2 lo, ImVec2 hi, const std::string& path, LayoutView& view) {
  if (node.leaf) return drawLeaf(node, lo, hi, view);
  const float gap = grid(1);
  const float length = node.side_by_side ? hi.x - lo.x : hi.y - lo.y;
  const float cut = std::round((length - gap) * node.ratio);
  ImVec2 first_hi = hi, second_lo = lo;
  if (node.side_by_side) {
    first_hi.x = lo.x + cut;
    second_lo.x = first_hi.x + gap;
  } else {
    first_hi.y = lo.y + cut;
    second_lo.y = first_hi.y + gap;
  }
  drawNode(*node.first, lo, first_hi, path + "0", view);
  drawNode(*node.second, second_lo, hi, path + "1", view);
  const ImVec2 gap_lo = node.side_by_side ? ImVec2{first_hi.x, lo.y} : ImVec2{lo.x, first_hi.y};
  const ImVec2 gap_hi = node.side_by_side ? ImVec2{second_lo.x, hi.y} : ImVec2{hi.x, second_lo.y};
  if (splitter(path.c_str(), gap_lo, gap_hi, node.side_by_side, length, grid(25), node.ratio)) {
    view.changed = true;
  }
}

}  // namespace

void drawLayout(Layout& layout, ImVec2 lo, ImVec2 hi, LayoutView& view) {
  if (view.maximized && !view.maximized->empty()) {
    LayoutNode alone;
    alone.panels = {*view.maximized};
    return drawLeaf(alone, lo, hi, view);
  }
  drawNode(layout.root, lo, hi, "s", view);
}

}  // namespace svoscope::ui
