// SPDX-License-Identifier: MIT
// What the panels write into files: numbers as CSV, charts as SVG, anything as PNG.
#pragma once

#include <filesystem>
#include <string>

#include "engine/base/result.h"
#include "ui/panels/panel_context.h"

namespace svoscope::ui {

/// Panels with charts: CSV and SVG.
bool exportsCharts(const std::string& panel);
/// Panels with numbers.
bool exportsNumbers(const std::string& panel);

/// What the panel shows, as comma-separated values. Usage error, saying what there is to do, for a
/// panel without numbers or with nothing to show.
Result<std::string> panelCsv(PanelContext& context, const std::string& panel);

/// "synthetic-room_it-svo_kl-js_00120.csv"; comparisons name the runs' sequence only.
std::string exportName(const PanelContext& context, const std::string& panel,
                       const std::string& extension);

/// Makes the folder. Output error naming the file.
Status writeExport(const std::filesystem::path& file, const std::string& text);

/// CSV of the panels' own files.
std::string plotsCsv(PanelContext& context);
std::string timingCsv(const PanelContext& context);
std::string errorCsv(const PanelContext& context);

}  // namespace svoscope::ui
