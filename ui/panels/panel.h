// SPDX-License-Identifier: MIT
// A panel as layouts, menus, exports and scripts know it. Each panel defines its own at the end of
// its file; panel_list.cpp lists them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ui/model/ui_state.h"

namespace svoscope::ui {

struct PanelContext;

/// A choice of the user that scripts can `set` and `expect`, as a number; choices count from 0.
struct PanelOption {
  std::string name;  ///< "image.trails"
  std::function<double(const UiState&)> get;
  std::function<void(UiState&, double)> set;
};

struct Panel {
  const char* name;  ///< title, and name in layouts and scripts
  void (*draw)(PanelContext&);
  /// The numbers it shows as comma-separated values, empty if there are none yet; null: it has
  /// none.
  std::string (*csv)(PanelContext&) = nullptr;
  bool charts = false;  ///< draws by ui/widgets/pen.h and can be saved as SVG
  std::vector<PanelOption> (*options)() = nullptr;  ///< what scripts can set; null: nothing
  bool exportable = true;                           ///< has an export button
};

/// In the order of the View menu.
const std::vector<const Panel*>& panels();
/// Null if there is none of that name.
const Panel* findPanel(const std::string& name);

/// A member of a part of the shared state.
template <typename Part, typename T>
PanelOption stateOption(const char* name, Part UiState::*part, T Part::*field) {
  return {name, [=](const UiState& s) { return static_cast<double>(s.*part.*field); },
          [=](UiState& s, double v) { s.*part.*field = static_cast<T>(v); }};
}

/// A member of a panel's own options: PanelContext::options<Options>().
template <typename Options, typename Base, typename T>
PanelOption windowOption(const char* name, T Base::*field) {
  return {name,
          [=](const UiState& s) { return static_cast<double>(s.options.get<Options>().*field); },
          [=](UiState& s, double v) { s.options.get<Options>().*field = static_cast<T>(v); }};
}

/// A member of a panel's own options in the current run: PanelContext::runOptions<Options>().
template <typename Options, typename Base, typename T>
PanelOption runOption(const char* name, T Base::*field) {
  return {
      name,
      [=](const UiState& s) { return static_cast<double>(s.run_options.get<Options>().*field); },
      [=](UiState& s, double v) { s.run_options.get<Options>().*field = static_cast<T>(v); }};
}

}  // namespace svoscope::ui
