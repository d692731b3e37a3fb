// SPDX-License-Identifier: MIT
// How the window is divided: a tree of splits whose leaves are groups of panels shown as tabs.
// Saved as one line of text.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace svoscope::ui {

struct LayoutNode {
  bool leaf = true;
  bool side_by_side = true;         ///< split: children left and right, else top and bottom
  float ratio = 0.5f;               ///< share of the first child
  std::vector<std::string> panels;  ///< leaf: titles, in tab order
  int active = 0;
  std::shared_ptr<LayoutNode> first, second;
};

struct Layout {
  std::string name;
  LayoutNode root;

  Layout() = default;
  Layout(const Layout& o) { *this = o; }
  Layout& operator=(const Layout& o);  ///< deep copy
};

const std::vector<std::string>&
presetNames();  ///< "Tracking", "Seeds", "KL / JS", "Evaluation", "Compare", "Image only"
Layout presetLayout(const std::string& name);  ///< "Tracking" if unknown

std::string layoutText(const Layout& layout);
/// The error says what is not understood; unknown panels are errors, too.
Result<Layout> parseLayout(const std::string& text);

Status saveLayout(const Layout& layout, const std::string& path);
Result<Layout> loadLayout(const std::string& path);
/// $XDG_CONFIG_HOME/svoscope/layout.txt, or ~/.config/... ; empty if neither is known.
std::string defaultLayoutPath();

bool hasPanel(const LayoutNode& node, const std::string& panel);
/// Whether the panel's tab is the active one.
bool isRaised(const LayoutNode& node, const std::string& panel);
/// Makes the panel's tab the active one; false if it is not in the layout.
bool raisePanel(LayoutNode& node, const std::string& panel);
/// Takes the panel out; a split that lost one side becomes the other.
void hidePanel(LayoutNode& node, const std::string& panel);
/// Adds the panel as a tab of the last leaf.
void showPanel(LayoutNode& node, const std::string& panel);

}  // namespace svoscope::ui
