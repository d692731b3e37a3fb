// SPDX-License-Identifier: MIT
// What the panels write into files: numbers as CSV, charts as SVG, anything as PNG.
#pragma once

#include <filesystem>
#include <string>

#include "engine/base/result.h"
#include "ui/panels/panel.h"
#include "ui/panels/panel_context.h"

namespace svoscope::ui {

/// What the panel shows, as comma-separated values. Usage error, saying what there is to do, for a
/// panel without numbers or with nothing to show.
Result<std::string> panelCsv(PanelContext& context, const Panel& panel);

/// "synthetic-room_it-svo_kl-js_00120.csv"; comparisons name the runs' sequence only.
std::string exportName(const PanelContext& context, const std::string& panel,
                       const std::string& extension);

/// Makes the folder. Output error naming the file.
Status writeExport(const std::filesystem::path& file, const std::string& text);

}  // namespace svoscope::ui
