// SPDX-License-Identifier: MIT
#include "ui/inspector.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "ui/layout_view.h"
#include "ui/palette.h"
#include "ui/panels/panel.h"
#include "ui/panels/run/window_bars.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/probe.h"

namespace svoscope::ui {

namespace {

constexpr std::uint32_t kRunSlots = 100;  // textures of a run's panels

bool beginFixed(const char* name, ImVec2 lo, ImVec2 hi, ImU32 color, ImVec2 padding) {
  ImGui::SetCursorScreenPos(lo);
  ImGui::GetWindowDrawList()->AddRectFilled(lo, hi, color);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  const bool open =
      ImGui::BeginChild(name, {std::max(1.0f, hi.x - lo.x), std::max(1.0f, hi.y - lo.y)}, false,
                        ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NoScrollbar |
                            ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  return open;
}

}  // namespace

Inspector::Inspector(Runner& runner, Graphics& graphics)
    : runner_(runner),
      graphics_(graphics),
      runs_(runner),
      views_(static_cast<std::size_t>(runs_.size())) {
  for (int i = 0; i < runs_.size(); ++i) caches_.push_back(std::make_unique<PanelCaches>());
}

void Inspector::applyTheme(float scale) {
  state_.ui_scale = scale;
  ui::applyTheme(scale);
}

std::optional<std::string> Inspector::takeScreenshotRequest() {
  return std::exchange(state_.screenshot, std::nullopt);
}

std::optional<float> Inspector::takeScaleRequest() {
  return std::exchange(scale_request_, std::nullopt);
}

void Inspector::useLayoutFile(const std::string& path) {
  layout_file_ = path;
  if (path.empty() || !std::filesystem::exists(path)) return;
  const auto layout = loadLayout(path);
  if (layout.ok())
    state_.layout = layout.value();
  else
    state_.toasts.add(layout.error().message(), true);
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

void Inspector::switchRun() {
  const int next = std::exchange(state_.run_request, -1), before = runs_.current();
  if (next < 0 || next == before) return;
  const Status status = runs_.setCurrent(next);
  if (!status.ok()) return state_.toasts.add(status.error().message(), true);
  UserView& left = views_[static_cast<std::size_t>(before)];
  left = {state_.selection, state_.highlighted, state_.seed.pinned, std::move(state_.run_options),
          state_.scene};
  UserView& entered = views_[static_cast<std::size_t>(next)];
  state_.selection = entered.selection;
  state_.highlighted = entered.highlighted;
  state_.seed.pinned = entered.pinned;
  state_.run_options = std::move(entered.run_options);
  // Maps differ in scale and direction: each has a viewpoint of its own, the filters are shared.
  const SceneOptions &from = entered.scene, filters = state_.scene;
  state_.scene = filters;
  state_.scene.target = from.target;
  state_.scene.distance = from.distance;
  state_.scene.yaw = from.yaw;
  state_.scene.pitch = from.pitch;
  state_.scene.fitted = from.fitted;
  state_.scene.fitted_points = from.fitted_points;
}

void Inspector::updateRuns() {
  for (int i = 0; i < runs_.size(); ++i) {
    if (!caches_[static_cast<std::size_t>(i)]->run.update(runs_.run(i))) continue;
    UserView& view = views_[static_cast<std::size_t>(i)];
    view = UserView();
    state_.viewed_frame = -1;
    if (i != runs_.current()) continue;
    state_.selection = {};
    state_.highlighted.clear();
    state_.seed.pinned.clear();
    state_.scene.fitted = false;
  }
}

PanelContext Inspector::makeContext() {
  switchRun();
  updateRuns();
  graphics_.setFirstSlot(kRunSlots * static_cast<std::uint32_t>(runs_.current()));
  PanelContext c{
      runner_,  runner_,        graphics_,        state_,           now(),   runs_,   caches_,
      compare_, runner_.info(), runner_.status(), runner_.latest(), nullptr, nullptr, runs_.frame(),
      renderer_};
  if (state_.viewed_frame >= c.engineFrame()) state_.viewed_frame = -1;
  c.snapshot = runs_.size() > 1 || !c.live() ? runner_.at(c.viewedFrame()) : c.latest;
  c.record = c.snapshot ? &c.snapshot->record : now().run.find(c.viewedFrame());
  now().truth.update(now().run.records(), c.info.ground_truth,
                     static_cast<Alignment>(state_.align_mode), now().run.generation(),
                     !c.status.playing);
  now().selection.update(runner_, state_.selection, c.latest);
  state_.linked_x.known = framesOf(caches_);
  return c;
}

void Inspector::draw() {
  // Before the context is made: this very frame shows what a shortcut changed.
  for (const Action action : pressedActions()) act(action);
  PanelContext context = makeContext();
  drawWindow(context);
  // The panel sets these again in every frame that it is shown; the image may be drawn before it.
  if (!std::exchange(state_.search_line.fresh, false)) state_.search_line = {};
  if (!std::exchange(state_.search_hover.fresh, false)) state_.search_hover = {};
  state_.seed.step_request = 0;
  finishExport(context);
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
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                   ImGuiWindowFlags_MenuBar | ImGuiWindowFlags_NoScrollWithMouse |
                   ImGuiWindowFlags_NoNavInputs);
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
  const float transport = state_.show_transport
                              ? std::round(lines * (ImGui::GetFrameHeight() + grid(1)) + grid(22))
                              : 0;
  const float transport_top = std::max(top, status_top - transport);
  LayoutView view;
  view.maximized = &state_.maximized;
  view.draw_panel = [&](const std::string& panel) {
    if (const Panel* found = findPanel(panel)) drawExporting(context, *found);
  };
  if (transport_top - top > grid(4)) {
    drawLayout(state_.layout, {0, top + grid(0.5f)}, {display.x, transport_top - grid(1)}, view);
  }
  if (view.changed) layoutChanged();
  if (!view.export_clicked.empty()) openExportMenu(view.export_clicked);
  drawExportMenu(context);
  if (transport > 0) {
    const ImVec2 lo{0, transport_top}, hi{display.x, status_top};
    if (beginFixed("##transport", lo, hi, ink::panel, {grid(2), grid(1.5f)}))
      drawTransportBar(context);
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
                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoResize |
                       ImGuiWindowFlags_NoSavedSettings)) {
    findPanel("Help")->draw(context);
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
  const int newest = runs_.frame();
  if (!back && (state_.viewed_frame < 0 || newest < 0)) return runner_.send(Command());
  if (newest < 0) return;
  const int first = runner_.status().history_first;
  const int now = state_.viewed_frame < 0 ? newest : state_.viewed_frame;
  const int target = back ? now - 1 : now + 1;
  if (target < first) return state_.toasts.add("No older frame is held");
  state_.viewed_frame = target >= newest ? -1 : target;
}

// Applied by the panel that shows the updates; nothing happens if none does.
void Inspector::stepUpdate(int by) { state_.seed.step_request += by; }

void Inspector::requestScreenshot() {
  const int frame = state_.viewed_frame >= 0 ? state_.viewed_frame : std::max(0, runs_.frame());
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
    case Action::none:
      return;
    case Action::play_pause:
      return togglePlay();
    case Action::step:
      return step(false);
    case Action::back:
      return step(true);
    case Action::next_keyframe:
      return run(Command::Kind::run_to_keyframe);
    case Action::next_loss:
      return run(Command::Kind::run_to_loss);
    case Action::first:
      if (runner_.latest()) state_.viewed_frame = runner_.status().history_first;
      return;
    case Action::live:
      state_.viewed_frame = -1;
      return;
    case Action::follow:
      state_.scene.follow = !state_.scene.follow;
      return;
    case Action::screenshot:
      return requestScreenshot();
    case Action::zoom_in:
      return zoomImage(state_.image.view, state_.image_fit, 1.25f);
    case Action::zoom_out:
      return zoomImage(state_.image.view, state_.image_fit, 0.8f);
    case Action::layout_1:
    case Action::layout_2:
    case Action::layout_3:
    case Action::layout_4:
    case Action::layout_5:
    case Action::layout_6:
      return showPreset(presetNames()[static_cast<std::size_t>(action) -
                                      static_cast<std::size_t>(Action::layout_1)]);
    case Action::next_run:
      state_.run_request = runs_.neighbour(1);
      return;
    case Action::previous_run:
      state_.run_request = runs_.neighbour(-1);
      return;
    case Action::previous_update:
      return stepUpdate(-1);
    case Action::next_update:
      return stepUpdate(1);
    case Action::help:
      state_.show_help = !state_.show_help;
      return;
    case Action::clear:
      if (state_.show_help)
        state_.show_help = false;
      else if (!state_.maximized.empty())
        state_.maximized.clear();
      else
        state_.selection = {};
      return;
  }
}

}  // namespace svoscope::ui
