// SPDX-License-Identifier: MIT
// Buttons, toggles and legends: ImGui's, recorded for the probe and saying why they are disabled.
#pragma once

#include <imgui/imgui.h>

#include <string>
#include <vector>

#include "ui/widgets/text.h"

namespace svoscope::ui {

/// Symbols drawn by us, so that no icon font is needed.
enum class Icon { play, pause, step, back, first, last, next_key, reset, none };

struct ControlHint {
  const char* tooltip = nullptr;
  const char* disabled_because = nullptr;  ///< not null: disabled, and this is the tooltip
};

bool button(const char* label, const ControlHint& hint = {}, bool highlighted = false);
/// A square button showing an icon; `label` names it in the probe and in the tooltip.
bool iconButton(const char* label, Icon icon, const ControlHint& hint, bool highlighted = false);
/// A compact on/off button, lit when on.
bool toggle(const char* label, bool& value, const char* tooltip = nullptr);
bool checkbox(const char* label, bool& value, const char* tooltip = nullptr);
bool combo(const char* label, int& index, const std::vector<const char*>& items, float width,
           const char* tooltip = nullptr);
bool slider(const char* label, float& value, float lo, float hi, const char* format, float width,
            const char* tooltip = nullptr);
bool inputText(const char* label, const char* hint, std::string& text, float width);
bool inputInt(const char* label, int& value, float width, const char* tooltip = nullptr);

/// Tooltip of the last item, also if it is disabled.
void tooltip(const char* text);
/// Continues on this line if `width` still fits, else on the next: toolbars that wrap.
void sameLineIfFits(float width);
/// Width of a button or toggle with this label.
float buttonWidth(const char* label);

/// A toolbar's on/off options: buttons that wrap, or a "Show" menu where room is short.
class OptionBar {
 public:
  explicit OptionBar(bool compact);
  ~OptionBar();
  OptionBar(const OptionBar&) = delete;
  void item(const char* label, bool& value, const char* hint);
  bool visible() const { return !compact_ || open_; }
  bool compact() const { return compact_; }

 private:
  bool compact_, open_ = false;
};
/// Whether the rest of the current window is too small for toolbars of several rows.
bool shortOfRoom();

enum class Swatch { square, line, dashed, dotted, cross, dot, ring };
/// Colour sample and text on the current line.
void legendEntry(ImU32 color, Swatch kind, const char* text);
float legendWidth(const char* text);

}  // namespace svoscope::ui
