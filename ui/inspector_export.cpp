// SPDX-License-Identifier: MIT
// Panels into files: from the Export menu of a panel's title and from scripts alike.
#include <filesystem>
#include <utility>

#include "ui/inspector.h"
#include "ui/palette.h"
#include "ui/panels/panel_export.h"
#include "ui/theme.h"
#include "ui/widgets/figure.h"
#include "ui/widgets/probe.h"

namespace svoscope::ui {

namespace {

bool isSvg(const ExportRequest& request) {
  return std::filesystem::path(request.file).extension() == ".svg";
}

bool item(const char* label) {
  const bool chosen = ImGui::MenuItem(label);
  Probe::record(label);
  return chosen;
}

}  // namespace

/// Notes what the panel draws if it is to be saved as SVG.
void Inspector::drawExporting(PanelContext& context, const Panel& panel) {
  const auto& request = state_.export_request;
  if (!request || request->panel != panel.name || !isSvg(*request)) return panel.draw(context);
  const ExportRequest wanted = *std::exchange(state_.export_request, std::nullopt);
  std::string svg;
  {
    Figure figure;
    panel.draw(context);
    if (!figure.empty()) svg = figure.svg(ink::panel);
  }
  const Status written =
      svg.empty() ? Status(usageError("the panel " + wanted.panel + " shows no chart yet",
                                      wanted.panel, "the panel says what it needs"))
                  : writeExport(wanted.file, svg);
  reportExport(wanted, written);
}

/// CSV needs no drawing; a panel that was to be saved as SVG and was not drawn is an error.
void Inspector::finishExport(PanelContext& context) {
  if (state_.picture_delay > 0) --state_.picture_delay;
  if (!state_.export_request || std::exchange(state_.export_request->fresh, false)) return;
  const ExportRequest request = *std::exchange(state_.export_request, std::nullopt);
  const Panel* panel = findPanel(request.panel);
  Status written = Done{};
  if (!panel) {
    written = usageError("no panel is called '" + request.panel + "'", "", "");
  } else if (isSvg(request)) {
    written = panel->charts ? usageError("the panel " + request.panel + " is not on screen",
                                         request.panel, "show it first")
                            : usageError("the panel " + request.panel + " has no charts",
                                         request.panel, "export it as .png");
  } else {
    const Result<std::string> text = panelCsv(context, *panel);
    written = text.ok() ? writeExport(request.file, text.value()) : Status(text.error());
  }
  reportExport(request, written);
}

void Inspector::reportExport(const ExportRequest& request, const Status& written) {
  state_.export_error = written.ok() ? "" : written.error().message();
  if (request.quiet) return;
  state_.toasts.add(written.ok() ? "Wrote " + request.file : state_.export_error, !written.ok());
}

void Inspector::openExportMenu(const std::string& panel) {
  state_.export_menu = panel;
  ImGui::OpenPopup("##export_menu");
}

void Inspector::drawExportMenu(PanelContext& context) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {grid(2), grid(2)});
  if (ImGui::BeginPopup("##export_menu")) {
    const std::string& panel = state_.export_menu;
    const Panel* found = findPanel(panel);
    const auto file = [&](const char* extension) {
      return (std::filesystem::path(state_.output_folder) / exportName(context, panel, extension))
          .string();
    };
    if (found && found->csv && item("Numbers, CSV"))
      state_.export_request = ExportRequest{panel, file(".csv"), false, true};
    if (item("Picture, PNG")) {
      state_.picture_request = ExportRequest{panel, file(".png"), false, true};
      state_.picture_delay = 3;
    }
    if (found && found->charts && item("Charts, SVG"))
      state_.export_request = ExportRequest{panel, file(".svg"), false, true};
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
}

std::optional<ExportRequest> Inspector::takePictureRequest() {
  if (state_.picture_delay > 0) return std::nullopt;
  return std::exchange(state_.picture_request, std::nullopt);
}

}  // namespace svoscope::ui
