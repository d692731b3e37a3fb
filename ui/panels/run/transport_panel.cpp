// SPDX-License-Identifier: MIT
#include <array>

#include "ui/model/run_length.h"
#include "ui/palette.h"
#include "ui/panels/panel_context.h"
#include "ui/panels/run/window_bars.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/probe.h"
#include "ui/widgets/timeline.h"

namespace svoscope::ui {

namespace {

struct TransportOptions {
  int speed = 0;     ///< index into the choice of speeds
  int run_to = 100;  ///< frame typed for "Run to frame"
};

const char* whyNoForward(const PanelContext& c) {
  if (!c.status.finished || !c.live()) return nullptr;
  return c.status.recorded ? "The recording ends here"
                           : "The last frame was processed, reset to run again";
}

const char* whyNoBack(const PanelContext& c) {
  if (!c.latest) return "No frame was processed yet";
  if (c.viewedFrame() <= c.status.history_first) return "No older frame is held";
  return nullptr;
}

void playButtons(PanelContext& c) {
  const bool playing = c.status.playing;
  if (iconButton("First", Icon::first, {"Oldest frame still held (Home)", whyNoBack(c)})) {
    c.state.viewed_frame = c.status.history_first;
  }
  ImGui::SameLine(0, grid(1));
  if (iconButton("Back", Icon::back, {"Show the frame before (Left)", whyNoBack(c)})) {
    c.view(c.viewedFrame() - 1);
  }
  ImGui::SameLine(0, grid(1));
  if (iconButton(playing ? "Pause" : "Play", playing ? Icon::pause : Icon::play,
                 {playing ? "Pause (Space)" : "Play (Space)",
                  !playing && !c.status.recorded ? whyNoForward(c) : nullptr},
                 playing)) {
    c.send(playing ? Command::Kind::pause : Command::Kind::play);
  }
  ImGui::SameLine(0, grid(1));
  const char* step_hint = c.live() ? "Process one frame (Right)" : "Show the frame after (Right)";
  if (iconButton("Step", Icon::step, {step_hint, whyNoForward(c)})) {
    if (c.live())
      c.send(Command::Kind::step);
    else
      c.view(c.viewedFrame() + 1);
  }
  ImGui::SameLine(0, grid(1));
  if (iconButton("Live", Icon::last,
                 {"Newest frame (End)", c.live() ? "The newest frame is shown" : nullptr})) {
    c.view(-1);
  }
}

void runButtons(PanelContext& c) {
  const ControlHint none{nullptr, whyNoForward(c)};
  const auto item = [&](const char* label, const char* hint, Command::Kind kind) {
    sameLineIfFits(buttonWidth(label));
    if (button(label, {hint, none.disabled_because})) c.send(kind);
  };
  ImGui::SameLine(0, grid(4));
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("Run to");
  item("Keyframe", "Run until the next keyframe (Shift+Right)", Command::Kind::run_to_keyframe);
  item("Loss", "Run until tracking is lost (L)", Command::Kind::run_to_loss);
  item("Start", "Run until the two-view start succeeded", Command::Kind::run_to_start);
  sameLineIfFits(buttonWidth("Frame") + grid(16));
  const bool past = c.options<TransportOptions>().run_to <= c.engineFrame();
  if (button("Frame", {"Run until this frame was processed",
                       past ? "That frame was processed already" : none.disabled_because})) {
    c.send(Command::Kind::run_to_frame, c.options<TransportOptions>().run_to);
  }
  ImGui::SameLine(0, grid(1));
  inputInt("##run_to_frame", c.options<TransportOptions>().run_to, ImGui::GetFontSize() * 3.6f,
           "Frame number");
}

void speedControl(PanelContext& c) {
  static const std::vector<const char*> names{"Max speed", "1 fps",  "2 fps", "5 fps",
                                              "10 fps",    "20 fps", "30 fps"};
  static const std::array<const char*, 7> values{"0", "1", "2", "5", "10", "20", "30"};
  const float width = ImGui::GetFontSize() * 6.5f;
  sameLineIfFits(width + grid(4));
  if (combo("##speed", c.options<TransportOptions>().speed, names, width,
            "Frames per second while playing")) {
    Command command;
    command.kind = Command::Kind::set_speed;
    command.value = values[static_cast<std::size_t>(c.options<TransportOptions>().speed)];
    c.runner.send(command);
  }
  sameLineIfFits(buttonWidth("Reset"));
  const char* reset_hint = c.status.recorded ? "Play the recording from its first frame again"
                                             : "Start again at the first frame with an empty map";
  if (button("Reset", {reset_hint, c.latest ? nullptr : "No frame was processed yet"})) {
    c.send(Command::Kind::reset);
  }
}

// Where one is: the newest frame, or in the past with a way back.
void position(PanelContext& c) {
  if (c.live()) {
    const std::string text = !c.latest           ? std::string("Not started")
                             : c.info.frames > 0 ? format("Frame %d (%d of %d)", c.engineFrame(),
                                                          c.engineFrame() + 1, frameCount(c))
                                                 : format("Frame %d", c.engineFrame());
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    sameLineIfFits(width);
    ImGui::SetCursorPosX(
        std::max(ImGui::GetCursorPosX(), ImGui::GetWindowContentRegionMax().x - width));
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(text.c_str());
    return;
  }
  const std::string text = format("Viewing frame %d, %s at %d", c.viewedFrame(),
                                  c.status.recorded ? "played" : "engine", c.engineFrame());
  const char* back = c.status.recorded ? "Back to the end" : "Back to live";
  const float width = ImGui::CalcTextSize(text.c_str()).x + grid(6) + buttonWidth(back);
  sameLineIfFits(width);
  ImGui::SetCursorPosX(
      std::max(ImGui::GetCursorPosX(), ImGui::GetWindowContentRegionMax().x - width));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddRectFilled({at.x, at.y},
                                            {at.x + width, at.y + ImGui::GetFrameHeight()},
                                            withAlpha(okabe::orange, 0.22f), dp(3));
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + grid(2));
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, toVec4(okabe::orange));
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
  Probe::record("viewing older frame", ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  ImGui::SameLine(0, grid(2));
  if (button(back, {"Show the newest frame again (End)"}, true)) c.view(-1);
}

}  // namespace

void drawTransportBar(PanelContext& c) {
  playButtons(c);
  runButtons(c);
  speedControl(c);
  position(c);
  TimelineSpec spec;
  spec.records = &c.caches.run.records();
  spec.events = &c.caches.run.events();
  spec.frames = std::max(frameCount(c), c.engineFrame() + 1);
  spec.history_first = c.status.history_first;
  spec.viewed = c.viewedFrame();
  spec.engine = c.engineFrame();
  spec.budget_ms = c.info.rate_hz > 0 ? 1000 / c.info.rate_hz : 0;
  spec.height = std::max(grid(16), ImGui::GetContentRegionAvail().y);
  const auto target = timeline("Timeline", spec);
  if (target && c.latest) {
    c.view(std::clamp(*target, std::min(c.status.history_first, c.lastFrame()), c.lastFrame()));
  }
}

}  // namespace svoscope::ui
