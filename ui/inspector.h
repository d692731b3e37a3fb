// SPDX-License-Identifier: MIT
// The whole user interface: menu, panels, transport, status bar, shortcuts. Drawn once per UI
// frame from one snapshot; everything it wants from the engine goes through Runner::send.
#pragma once

#include <optional>
#include <string>

#include "engine/runner/runner.h"
#include "ui/actions.h"
#include "ui/content.h"
#include "ui/model/runs.h"
#include "ui/model/ui_state.h"
#include "ui/panels/compare/compare_data.h"
#include "ui/panels/panel_context.h"
#include "ui/render/slot_graphics.h"

namespace svoscope::ui {

struct Panel;

class Inspector : public UiContent {
 public:
  /// Several runs in lockstep if `runner` is a LockstepRunner.
  Inspector(Runner& runner, Graphics& graphics);

  void draw() override;
  void applyTheme(float scale) override;
  bool wantsClose() const override { return state_.close; }
  std::optional<std::string> takeScreenshotRequest() override;

  UiState& state() { return state_; }
  /// Of the current run.
  const PanelCaches& caches() const { return *caches_[static_cast<std::size_t>(runs_.current())]; }
  const CompareData& compare() const { return compare_; }

  /// Restores the layout from `path` if it is there, and saves it there when it changes. Not used
  /// without a window, so that pictures do not depend on what was saved.
  void useLayoutFile(const std::string& path);
  /// What renders, for the status bar.
  void setRenderer(const std::string& description) { renderer_ = description; }
  /// A panel to be saved as a picture, once, when nothing lies over it any more.
  std::optional<ExportRequest> takePictureRequest();
  /// UI scale chosen in the menu, once; the host makes fonts and theme of that size.
  std::optional<float> takeScaleRequest();

  /// Does what the shortcut does; also used by the menu.
  void act(Action action);
  void showPreset(const std::string& name);

 private:
  /// What the user looks at in a run; kept while another one is the current one.
  struct UserView {
    Selection selection;
    std::set<std::int64_t> highlighted;
    std::vector<std::int64_t> pinned;
    TypedStore run_options;
    SceneOptions scene;
  };

  PanelContext makeContext();
  PanelCaches& now() { return *caches_[static_cast<std::size_t>(runs_.current())]; }
  void switchRun();
  void updateRuns();
  void drawWindow(PanelContext& context);
  void drawBody(PanelContext& context);
  void drawHelp(PanelContext& context);
  void drawMenu(PanelContext& context);
  void drawFileMenu(PanelContext& context);
  void drawRunMenu(PanelContext& context);
  void drawViewMenu();
  void drawRunTabs();
  void drawExporting(PanelContext& context, const Panel& panel);
  void openExportMenu(const std::string& panel);
  void drawExportMenu(PanelContext& context);
  void finishExport(PanelContext& context);
  void reportExport(const ExportRequest& request, const Status& written);
  void step(bool back);
  void stepUpdate(int by);
  void togglePlay();
  void requestScreenshot();
  void layoutChanged();

  Runner& runner_;
  SlotGraphics graphics_;
  Runs runs_;
  UiState state_;
  std::vector<std::unique_ptr<PanelCaches>> caches_;  ///< of each run
  std::vector<UserView> views_;                       ///< of each run
  CompareData compare_;
  std::string layout_file_, renderer_;
  std::optional<float> scale_request_;
};

}  // namespace svoscope::ui
