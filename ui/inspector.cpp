// SPDX-License-Identifier: MIT
#include "ui/inspector.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

#include "ui/layout_view.h"
#include "ui/palette.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/probe.h"

namespace svoscope::ui {

namespace {

const std::map<std::string, void (*)(PanelContext&)>& panelTable() {
  static const std::map<std::string, void (*)(PanelContext&)> table{
      {"Image", drawImagePanel},           {"3-D", drawScenePanel},
      {"Seed", drawSeedPanel},             {"Epipolar search", drawEpipolarPanel},
      {"KL / JS", drawDivergencePanel},    {"Filter lab", drawLabPanel},
      {"Plots", drawPlotsPanel},           {"Timing", drawTimingPanel},
      {"Funnel", drawFunnelPanel},         {"Selection", drawSelectionPanel},
      {"Evaluation", drawEvaluationPanel}, {"Parameters", drawParametersPanel},
      {"Log", drawLogPanel},               {"Help", drawHelpPanel}};
  return table;
}

bool beginFixed(const char* name, ImVec2 lo, ImVec2 hi, ImU32 color, ImVec2 padding) {
  ImGui::SetCursorScreenPos(lo);
  ImGui::GetWindowDrawList()->AddRectFilled(lo, hi, color);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  const bool open = ImGui::BeginChild(name, {std::max(1.0f, hi.x - lo.x), std::max(1.0f, hi.y - lo.y)}, false,
                                      ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NoScrollbar |
                                          ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  return open;
}

}  // namespace

Inspector::Inspector(Runner& runner, Graphics& graphics) : runner_(runner), graphics_(graphics) {}

void Inspector::applyTheme(float scale) {
  state_.ui_scale = scale;
  ui::applyTheme(scale);
}

std::optional<std::string> Inspector::takeScreenshotRequest() {
  return std::exchange(state_.screenshot, std::nullopt);
}

std::optional<float> Inspector::takeScaleRequest() { return std::exchange(scale_request_, std::nullopt); }

void Inspector::useLayoutFile(const std::string& path) {
  layout_file_ = path;
  if (path.empty() || !std::filesystem::exists(path)) return;
  const auto layout = loadLayout(path);
  if (layout.ok()) state_.layout = layout.value();
  else state_.toasts.add(layout.error().message(), true);
}

void Inspector::layoutChanged() {
  if (layout_file_.empty()) return;
  const Status saved = saveLayout(state_.layout, layout_file_);
  if (!saved.ok()) state_.toasts.add(saved.error().message(), true);
}

void Inspector::showPreset(const std::string& name) {
  state_.layout = presetLayout(name);
  state_.maximized.clear();
  layoutChanged();
}

PanelContext Inspector::makeContext() {
  if (caches_.run.update(runner_)) {
    state_.viewed_frame = -1;
    state_.selection = {};
    state_.highlighted.clear();
    state_.seed.pinned.clear();
    state_.divergence.brushed = false;
    state_.scene.fitted = false;
  }
  PanelContext c{runner_, graphics_, state_, caches_, runner_.info(), runner_.status(), runner_.latest(),
                 nullptr, nullptr, renderer_};
  if (state_.viewed_frame >= c.engineFrame()) state_.viewed_frame = -1;
  c.snapshot = c.live() ? c.latest : runner_.at(state_.viewed_frame);
  c.record = c.snapshot ? &c.snapshot->record : caches_.run.find(c.viewedFrame());
  caches_.truth.update(caches_.run.records(), c.info.ground_truth, static_cast<AlignMode>(state_.align_mode),
                       caches_.run.generation(), !c.status.playing);
  caches_.selection.update(runner_, state_.selection, c.latest);
  return c;
}

void Inspector::draw() {
  // Before the context is made: this very frame shows what a shortcut changed.
  for (const Action action : pressedActions()) act(action);
  PanelContext context = makeContext();
  drawWindow(context);
  // The panel sets these anew in every frame that it is shown; the image may be drawn before it.
  if (!std::exchange(state_.search_line.fresh, false)) state_.search_line = {};
  if (!std::exchange(state_.search_hover.fresh, false)) state_.search_hover = {};
  state_.seed.step_request = 0;
  drawHelp(context);
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  state_.toasts.draw({display.x - grid(3), display.y - grid(9)});
}

void Inspector::drawWindow(PanelContext& context) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize({std::max(1.0f, display.x), std::max(1.0f, display.y)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::Begin("##inspector", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_MenuBar |
                   ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoNavInputs);
  ImGui::PopStyleVar(2);
  drawMenu(context);
  drawBody(context);
  ImGui::End();
}

void Inspector::drawBody(PanelContext& context) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float top = ImGui::GetCursorScreenPos().y;
  const float status = state_.show_status ? std::round(ImGui::GetFontSize() + grid(2)) : 0;
  const float status_top = display.y - status;
  // A narrow window wraps the transport's buttons: give it the lines it needs.
  const float lines = display.x < ImGui::GetFontSize() * 62 ? 2 : 1;
  const float transport =
      state_.show_transport ? std::round(lines * (ImGui::GetFrameHeight() + grid(1)) + grid(22)) : 0;
  const float transport_top = std::max(top, status_top - transport);
  LayoutView view;
  view.maximized = &state_.maximized;
  view.draw_panel = [&](const std::string& panel) {
    const auto found = panelTable().find(panel);
    if (found != panelTable().end()) found->second(context);
  };
  if (transport_top - top > grid(4)) {
    drawLayout(state_.layout, {0, top + grid(0.5f)}, {display.x, transport_top - grid(1)}, view);
  }
  if (view.changed) layoutChanged();
  if (transport > 0) {
    const ImVec2 lo{0, transport_top}, hi{display.x, status_top};
    if (beginFixed("##transport", lo, hi, ink::panel, {grid(2), grid(1.5f)})) drawTransportPanel(context);
    ImGui::EndChild();
    Probe::record("panel:Transport", lo, hi);
  }
  if (status > 0) {
    const ImVec2 lo{0, status_top}, hi{display.x, display.y};
    if (beginFixed("##status", lo, hi, ink::title, {grid(2), grid(1)})) drawStatusBar(context);
    ImGui::EndChild();
    Probe::record("panel:Status", lo, hi);
  }
}

void Inspector::drawHelp(PanelContext& context) {
  if (!state_.show_help) return;
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float width = std::min(display.x - grid(4), ImGui::GetFontSize() * 30);
  ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({width, std::min(display.y - grid(10), ImGui::GetFontSize() * 46)});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, toVec4(IM_COL32(30, 34, 40, 252)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  if (ImGui::Begin("Help", &state_.show_help,
                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings)) {
    drawHelpPanel(context);
  }
  ImGui::End();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
}

void Inspector::togglePlay() {
  Command command;
  command.kind = runner_.status().playing ? Command::Kind::pause : Command::Kind::play;
  moveOn(runner_, state_, command);
}

void Inspector::step(bool back) {
  const SnapshotPtr latest = runner_.latest();
  if (!back && (state_.viewed_frame < 0 || !latest)) return runner_.send(Command());
  if (!latest) return;
  const int first = runner_.status().history_first, newest = latest->record.index;
  const int now = state_.viewed_frame < 0 ? newest : state_.viewed_frame;
  const int target = back ? now - 1 : now + 1;
  if (target < first) return state_.toasts.add("No older frame is held");
  state_.viewed_frame = target >= newest ? -1 : target;
}

// Applied by the panel that shows the updates; nothing happens if none does.
void Inspector::stepUpdate(int by) { state_.seed.step_request += by; }

void Inspector::requestScreenshot() {
  const SnapshotPtr latest = runner_.latest();
  const int frame = state_.viewed_frame >= 0 ? state_.viewed_frame : latest ? latest->record.index : 0;
  const std::string name = runName(runner_.info()) + format("_frame%05d.png", frame);
  state_.screenshot = (std::filesystem::path(state_.output_folder) / name).string();
  state_.toasts.add("Screenshot " + name);
}

void Inspector::act(Action action) {
  const auto run = [this](Command::Kind kind) {
    Command command;
    command.kind = kind;
    moveOn(runner_, state_, command);
  };
  switch (action) {
    case Action::none: return;
    case Action::play_pause: return togglePlay();
    case Action::step: return step(false);
    case Action::back: return step(true);
    case Action::next_keyframe: return run(Command::Kind::run_to_keyframe);
    case Action::next_loss: return run(Command::Kind::run_to_loss);
    case Action::first:
      if (runner_.latest()) state_.viewed_frame = runner_.status().history_first;
      return;
    case Action::live: state_.viewed_frame = -1; return;
    case Action::follow: state_.scene.follow = !state_.scene.follow; return;
    case Action::screenshot: return requestScreenshot();
    case Action::zoom_in: return zoomImage(state_.image.view, state_.image_fit, 1.25f);
    case Action::zoom_out: return zoomImage(state_.image.view, state_.image_fit, 0.8f);
    case Action::layout_1:
    case Action::layout_2:
    case Action::layout_3:
    case Action::layout_4:
    case Action::layout_5:
      return showPreset(presetNames()[static_cast<std::size_t>(action) - static_cast<std::size_t>(Action::layout_1)]);
    case Action::previous_update: return stepUpdate(-1);
    case Action::next_update: return stepUpdate(1);
    case Action::help: state_.show_help = !state_.show_help; return;
    case Action::clear:
      if (state_.show_help) state_.show_help = false;
      else if (!state_.maximized.empty()) state_.maximized.clear();
      else state_.selection = {};
      return;
  }
}

}  // namespace svoscope::ui
