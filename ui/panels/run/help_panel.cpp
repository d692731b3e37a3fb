// SPDX-License-Identifier: MIT
#include "ui/actions.h"
#include "ui/palette.h"
#include "ui/panels/panel.h"
#include "ui/panels/panel_context.h"
#include "ui/render/fonts.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"

namespace svoscope::ui {

namespace {

void row(const char* keys, const char* what) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(keys);
  ImGui::TableNextColumn();
  ImGui::TextDisabled("%s", what);
}

bool beginTable(const char* title) {
  heading(title);
  if (!ImGui::BeginTable(title, 2, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_RowBg))
    return false;
  ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthFixed, ImGui::GetFontSize() * 9);
  ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch);
  return true;
}

void draw(PanelContext&) {
  if (beginTable("Keyboard")) {
    for (const Shortcut& s : shortcuts()) row(s.keys, s.what);
    ImGui::EndTable();
  }
  if (beginTable("Image")) {
    row("Wheel", "Zoom at the cursor");
    row("Drag", "Pan");
    row("Double-click", "Fit");
    row("Click", "Select the nearest feature or seed");
    ImGui::EndTable();
  }
  if (beginTable("3-D")) {
    row("Drag", "Orbit");
    row("Right drag", "Pan, also Shift + drag");
    row("Wheel", "Zoom");
    row("Click", "Select the nearest point");
    ImGui::EndTable();
  }
  if (beginTable("Plots and timeline")) {
    row("Wheel", "Zoom the frames, with Ctrl the values");
    row("Drag", "Pan, on the timeline scrub");
    row("Double-click", "Fit");
    row("Click", "View that frame");
    row("Right-click", "Logarithmic scale, export");
    ImGui::EndTable();
  }
  if (beginTable("Several runs")) {
    row("R, Shift + R", "Next run, run before; also a click on its tab");
    row("Click an image", "In Compare images: make that run the current one");
    row("Wheel, drag", "In Compare images: zoom and pan all alike");
    ImGui::EndTable();
  }
  if (beginTable("Panels")) {
    row("Export", "Numbers as CSV, charts as SVG, the panel as PNG");
    row("Double-click title", "Maximise, again to restore");
    row("Drag the gap", "Resize");
    ImGui::EndTable();
  }
}

}  // namespace

extern const Panel kHelpPanel{"Help",
                              draw,
                              /*csv=*/nullptr,
                              /*charts=*/false,
                              /*options=*/nullptr,
                              /*exportable=*/false};

}  // namespace svoscope::ui
