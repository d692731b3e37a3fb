// SPDX-License-Identifier: MIT
// The three fonts of the UI, at the size of the current scale.
#pragma once

#include <imgui/imgui.h>

#include <string>
#include <vector>

namespace svoscope::ui {

/// Builds the current context's atlas for `scale`: text of 15 px, monospaced digits, bold titles.
/// Fonts come from Debian's fonts-dejavu-core; SVOSCOPE_FONT and SVOSCOPE_FONT_MONO name others.
/// Returns one warning per font that was not found and fell back to ImGui's built-in one.
std::vector<std::string> buildFonts(float scale);

/// Null-safe between buildFonts calls: an absent font is the default one.
ImFont* textFont();
ImFont* monoFont();
ImFont* titleFont();

}  // namespace svoscope::ui
