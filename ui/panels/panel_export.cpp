// SPDX-License-Identifier: MIT
#include "ui/panels/panel_export.h"

#include <algorithm>
#include <cctype>

#include "engine/io/text_output.h"
#include "ui/widgets/controls.h"

namespace svoscope::ui {

namespace {

std::string slug(const std::string& panel) {
  std::string name;
  for (const char ch : panel) {
    if (std::isalnum(static_cast<unsigned char>(ch)))
      name += static_cast<char>(std::tolower(static_cast<unsigned char>(ch)));
    else if (!name.empty() && name.back() != '-')
      name += '-';
  }
  return name;
}

std::string namesWithNumbers() {
  std::vector<std::string> names;
  for (const Panel* panel : panels()) {
    if (panel->csv) names.emplace_back(panel->name);
  }
  std::sort(names.begin(), names.end());
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

Result<std::string> panelCsv(PanelContext& c, const Panel& panel) {
  const std::string name = panel.name;
  if (!panel.csv) {
    return usageError("the panel " + name + " has no numbers to write", name,
                      "as CSV there are: " + namesWithNumbers());
  }
  std::string text = panel.csv(c);
  if (!text.empty()) return text;
  return usageError("the panel " + name + " shows no numbers yet", name,
                    "the panel says what it needs");
}

std::string exportName(const PanelContext& c, const std::string& panel,
                       const std::string& extension) {
  RunInfo info;
  info.sequence = c.info.sequence;
  info.method = panel.rfind("Compare", 0) == 0 ? "runs" : c.runs.style(c.runs.current()).name;
  return runName(info) + "_" + slug(panel) + format("_%05d", std::max(0, c.viewedFrame())) +
         extension;
}

Status writeExport(const std::filesystem::path& file, const std::string& text) {
  const Status made = file.has_parent_path() ? makeFolder(file.parent_path()) : Status(Done{});
  return made.ok() ? writeWhole(file, text) : made;
}

}  // namespace svoscope::ui
