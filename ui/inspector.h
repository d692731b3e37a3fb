// SPDX-License-Identifier: MIT
// The whole user interface: menu, panels, transport, status bar, shortcuts. Drawn once per UI
// frame from one snapshot; everything it wants from the engine goes through Runner::send.
#pragma once

#include <optional>
#include <string>

#include "engine/runner/runner.h"
#include "ui/actions.h"
#include "ui/content.h"
#include "ui/panels/panel_context.h"
#include "ui/render/graphics.h"
#include "ui/ui_state.h"

namespace svoscope::ui {

class Inspector : public UiContent {
 public:
  Inspector(Runner& runner, Graphics& graphics);

  void draw() override;
  void applyTheme(float scale) override;
  bool wantsClose() const override { return state_.close; }
  std::optional<std::string> takeScreenshotRequest() override;

  UiState& state() { return state_; }
  const PanelCaches& caches() const { return caches_; }

  /// Restores the layout from `path` if it is there, and saves it there when it changes. Not used
  /// without a window, so that pictures do not depend on what was saved.
  void useLayoutFile(const std::string& path);
  /// What renders, for the status bar.
  void setRenderer(const std::string& description) { renderer_ = description; }
  /// UI scale chosen in the menu, once; the host makes fonts and theme of that size.
  std::optional<float> takeScaleRequest();

  /// Does what the shortcut does; also used by the menu.
  void act(Action action);
  void showPreset(const std::string& name);

 private:
  PanelContext makeContext();
  void drawWindow(PanelContext& context);
  void drawBody(PanelContext& context);
  void drawHelp(PanelContext& context);
  void drawMenu(PanelContext& context);
  void drawFileMenu(PanelContext& context);
  void drawRunMenu(PanelContext& context);
  void drawViewMenu();
  void step(bool back);
  void stepUpdate(int by);
  void togglePlay();
  void requestScreenshot();
  void layoutChanged();

  Runner& runner_;
  Graphics& graphics_;
  UiState state_;
  PanelCaches caches_;
  std::string layout_file_, renderer_;
  std::optional<float> scale_request_;
};

}  // namespace svoscope::ui
