// SPDX-License-Identifier: MIT
#include "ui/panels/panel_context.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <utility>

#include "ui/widgets/controls.h"

namespace svoscope::ui {

Range framesOf(const std::vector<std::unique_ptr<PanelCaches>>& runs) {
  Range frames{1e30, -1e30};
  for (const auto& caches : runs) {
    const auto& records = caches->run.records();
    if (records.empty()) continue;
    frames.lo = std::min<double>(frames.lo, records.front().index);
    frames.hi = std::max<double>(frames.hi, records.back().index);
  }
  return frames;
}

void moveOn(Runner& runner, UiState& state, const Command& command) {
  int from = std::exchange(state.viewed_frame, -1);  // whoever moves the engine wants to see it
  const RunnerStatus status = runner.status();
  if (status.finished && from < 0 && command.kind == Command::Kind::play)
    from = status.history_first;
  if (status.recorded && from >= 0 && command.kind != Command::Kind::reset) {
    Command jump;
    jump.kind = Command::Kind::run_to_frame;
    jump.frame = from;
    runner.send(jump);
  }
  runner.send(command);
}

bool saysWhyEmpty(const PanelContext& context) {
  if (context.snapshot) return false;
  if (!context.latest && context.engineFrame() >= 0) {
    emptyState("This run has no frame yet",
               format("The others are at frame %d", context.engineFrame()));
  } else if (!context.latest) {
    emptyState("No frame yet", "Press Space to play, or the right arrow key to process one frame");
  } else if (context.latest->record.index < context.viewedFrame()) {
    emptyState(format("This run has no frame %d", context.viewedFrame()).c_str(),
               format("Its last one is frame %d", context.latest->record.index));
  } else {
    emptyState(format("Frame %d is no longer held", context.viewedFrame()).c_str(),
               format("The history budget keeps frames from %d on; its numbers remain in the plots",
                      context.status.history_first));
  }
  return true;
}

std::string runName(const RunInfo& info) {
  std::string name = info.sequence + "_" + info.method;
  for (char& c : name) {
    if (c == '/' || c == ':' || c == ' ' || c == '\\') c = '-';
  }
  return name;
}

void exportText(PanelContext& context, const std::string& name, const std::string& text) {
  const std::filesystem::path path =
      std::filesystem::path(context.state.output_folder) / (runName(context.info) + "_" + name);
  std::ofstream out(path);
  out << text;
  out.close();
  if (out)
    context.state.toasts.add("Wrote " + path.string());
  else
    context.state.toasts.add("Cannot write " + path.string() + ", check the folder", true);
}

}  // namespace svoscope::ui
