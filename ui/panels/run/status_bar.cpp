// SPDX-License-Identifier: MIT
#include "ui/model/run_length.h"
#include "ui/palette.h"
#include "ui/panels/panel_context.h"
#include "ui/panels/run/window_bars.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/icons.h"

namespace svoscope::ui {

namespace {

void part(const std::string& text, ImU32 color = ink::dim) {
  ImGui::PushStyleColor(ImGuiCol_Text, toVec4(color));
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
}

void gap() {
  ImGui::SameLine(0, grid(3));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddLine({at.x, at.y + grid(0.5f)},
                                      {at.x, at.y + ImGui::GetTextLineHeight() - grid(0.25f)},
                                      ink::line);
  ImGui::Dummy({1, 1});
  ImGui::SameLine(0, grid(3));
}

void stateParts(const PanelContext& c) {
  if (!c.record)
    return part(c.engineFrame() < 0 ? "Waiting for the first frame" : "This run has no such frame");
  legendEntry(stateColor(c.record->state), Swatch::dot, stateLabel(c.record->state));
  if (const std::string reason = stateReason(*c.record); !reason.empty()) {
    const float end = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    const float room = end - ImGui::GetItemRectMax().x - 2 * grid(3) - dp(1);
    if (room < ImGui::GetFontSize() * 6) return;  // Funnel and Image say it, too
    gap();
    part(elided(reason, room), c.record->state == TrackingState::lost ? okabe::orange : ink::dim);
  }
}

std::string engineText(const PanelContext& c) {
  const double mb = 1.0 / (1024 * 1024);
  // Of the time that the engine itself takes, not of how often it is asked for a frame.
  std::string text = c.status.fps > 0 ? format("engine %.1f fps   ", c.status.fps) : std::string();
  if (c.status.mapping_queue > 0) text += format("queue %d   ", c.status.mapping_queue);
  if (c.status.recorded) {
    text += "recording";
  } else {
    text += format("history %.0f of %.0f MB", static_cast<double>(c.status.history_bytes) * mb,
                   static_cast<double>(c.status.history_budget) * mb);
  }
  if (!c.size_text.empty()) text += "   " + c.size_text;
  return text;
}

}  // namespace

void drawStatusBar(PanelContext& c) {
  const std::string sequence = c.info.sequence.empty() ? "No sequence" : c.info.sequence;
  part(elided(sequence, 0.4f * ImGui::GetContentRegionAvail().x), ink::text);
  if (!c.info.sequence.empty()) tooltip(sequence.c_str());
  gap();
  const RunStyle& run = c.runs.style(c.runs.current());
  legendEntry(run.color, Swatch::line, run.label.c_str());
  gap();
  part(c.latest ? format("frame %d (%d of %d)", c.viewedFrame(), c.viewedFrame() + 1, frameCount(c))
                : format("%d frames", frameCount(c)));
  if (c.info.times == "assumed") {
    gap();
    part(format("times assumed: %.0f Hz", c.info.rate_hz), okabe::orange);
  }
  gap();
  stateParts(c);
  const std::string right = engineText(c);
  const float width = ImGui::CalcTextSize(right.c_str()).x;
  const float start = ImGui::GetWindowContentRegionMax().x - width;
  if (ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x + grid(4) < start) {
    ImGui::SameLine(start);
    part(right);
  }
}

}  // namespace svoscope::ui
