// SPDX-License-Identifier: MIT
// The inspector's menu bar.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "ui/inspector.h"
#include "ui/palette.h"
#include "ui/panels/compare/compare_panel.h"
#include "ui/panels/export.h"
#include "ui/panels/panel.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/probe.h"

namespace svoscope::ui {

namespace {

bool menuItem(const char* label, const char* keys = nullptr, bool checked = false,
              bool enabled = true) {
  const bool chosen = ImGui::MenuItem(label, keys, checked, enabled);
  Probe::record(label);
  return chosen;
}

bool beginMenu(const char* label) {
  const bool open = ImGui::BeginMenu(label);
  // The item's rectangle is that of the bar's entry only while the menu is closed.
  if (!open) Probe::record(label);
  return open;
}

float runTabWidth(const RunStyle& style) {
  return ImGui::CalcTextSize(style.label.c_str()).x + ImGui::GetFontSize() + grid(4);
}

bool runTab(const RunStyle& style, ImVec2 at, float width, bool current) {
  const float pad = grid(2), swatch = ImGui::GetFontSize(), height = ImGui::GetFrameHeight();
  const ImVec2 hi{at.x + width, at.y + height};
  ImGui::SetCursorScreenPos(at);
  const bool pressed = ImGui::InvisibleButton("##run", {width, height});
  const bool hovered = ImGui::IsItemHovered(), cut = width < runTabWidth(style) - 1;
  Probe::record("run:" + style.name, at, hi);
  const char* hint = style.poses_only ? "Trajectory of another system, in the Compare panels"
                     : current        ? "The current run"
                                      : "Make it the current run (R: next)";
  tooltip(cut ? (style.label + "\n" + hint).c_str() : hint);
  ImDrawList* list = ImGui::GetWindowDrawList();
  if (current) list->AddRectFilled(at, hi, ink::panel);
  if (current) list->AddRectFilled(at, {hi.x, at.y + dp(2)}, style.color);
  drawSwatch(swatchOf(style.dash), {at.x + pad + swatch * 0.4f, at.y + height / 2}, swatch * 0.28f,
             style.color);
  const ImU32 color = !style.poses_only && (current || hovered) ? ink::text : ink::dim;
  const std::string label = cut ? elided(style.label, width - swatch - 2 * pad) : style.label;
  list->AddText({at.x + pad + swatch, at.y + (height - ImGui::GetFontSize()) / 2}, color,
                label.c_str());
  return pressed;
}

}  // namespace

void Inspector::drawFileMenu(PanelContext& context) {
  const bool any = !now().run.records().empty();
  if (menuItem("Screenshot", "P")) act(Action::screenshot);
  if (menuItem("Export trajectory", "TUM", false, any)) {
    exportText(context, "trajectory.txt", trajectoryText(now().run.records()));
  }
  if (menuItem("Export frames", "CSV", false, any)) {
    exportText(context, "frames.csv", framesCsv(now().run));
  }
  ImGui::Separator();
  if (menuItem("Quit")) state_.close = true;
}

void Inspector::drawRunMenu(PanelContext& context) {
  if (menuItem(context.status.playing ? "Pause##menu" : "Play##menu", "Space"))
    act(Action::play_pause);
  if (menuItem("One frame forward", "Right")) act(Action::step);
  if (menuItem("One frame back", "Left", false, context.latest != nullptr)) act(Action::back);
  ImGui::Separator();
  if (menuItem("To next keyframe", "Shift + Right")) act(Action::next_keyframe);
  if (menuItem("To loss of tracking", "L")) act(Action::next_loss);
  if (menuItem("To two-view start")) context.send(Command::Kind::run_to_start);
  if (runs_.size() > 1 && menuItem("Next run", "R")) act(Action::next_run);
  ImGui::Separator();
  if (menuItem("Reset##menu")) context.send(Command::Kind::reset);
}

void Inspector::drawViewMenu() {
  const char* keys[] = {"1", "2", "3", "4", "5", "6"};
  for (std::size_t i = 0; i < presetNames().size(); ++i) {
    const std::string label = presetNames()[i] + " layout";
    if (menuItem(label.c_str(), keys[i], state_.layout.name == presetNames()[i]))
      showPreset(presetNames()[i]);
  }
  if (menuItem("Reset layout")) showPreset(state_.layout.name);
  ImGui::Separator();
  for (const Panel* each : panels()) {
    const std::string panel = each->name;
    const bool shown = hasPanel(state_.layout.root, panel);
    const std::string label = panel + " panel";
    if (!menuItem(label.c_str(), nullptr, shown)) continue;
    if (shown)
      hidePanel(state_.layout.root, panel);
    else
      showPanel(state_.layout.root, panel);
    layoutChanged();
  }
  menuItem("Timeline##menu", nullptr, state_.show_transport) && (state_.show_transport ^= true);
  menuItem("Status bar", nullptr, state_.show_status) && (state_.show_status ^= true);
  ImGui::Separator();
  if (!beginMenu("Interface scale")) return;
  for (const float scale : {0.75f, 1.0f, 1.25f, 1.5f, 2.0f, 2.5f, 3.0f}) {
    const bool current = std::abs(scale - state_.ui_scale) < 0.01f;
    if (menuItem(format("%g", scale).c_str(), nullptr, current)) scale_request_ = scale;
  }
  ImGui::EndMenu();
}

/// One tab per run at the right end of the bar; trajectories are listed, too, but cannot be
/// entered. Where they do not fit, the longest labels are shortened.
void Inspector::drawRunTabs() {
  if (runs_.size() < 2) return;
  const float gap = grid(1), right = ImGui::GetWindowPos().x + ImGui::GetWindowWidth() - grid(1);
  std::vector<float> widths;
  for (int i = 0; i < runs_.size(); ++i) widths.push_back(runTabWidth(runs_.style(i)) + gap);
  ImVec2 at = ImGui::GetCursorScreenPos();
  at.x += grid(2);
  widths = sharedWidths(widths, right - at.x);
  at.x = std::max(at.x, right - std::accumulate(widths.begin(), widths.end(), 0.0f));
  for (int i = 0; i < runs_.size(); ++i) {
    const RunStyle& style = runs_.style(i);
    const float width = widths[static_cast<std::size_t>(i)];
    ImGui::PushID(i);
    const bool pressed = runTab(style, at, std::max(1.0f, width - gap), i == runs_.current());
    ImGui::PopID();
    if (pressed && !style.poses_only) state_.run_request = i;
    at.x += width;
  }
}

void Inspector::drawMenu(PanelContext& context) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {grid(2), grid(2)});
  if (ImGui::BeginMenuBar()) {
    if (beginMenu("File")) {
      drawFileMenu(context);
      ImGui::EndMenu();
    }
    if (beginMenu("Run")) {
      drawRunMenu(context);
      ImGui::EndMenu();
    }
    if (beginMenu("View")) {
      drawViewMenu();
      ImGui::EndMenu();
    }
    if (beginMenu("Help")) {
      if (menuItem("Shortcuts…", "?")) state_.show_help = true;
      ImGui::EndMenu();
    }
    drawRunTabs();
    ImGui::EndMenuBar();
  }
  ImGui::PopStyleVar();
}

}  // namespace svoscope::ui
