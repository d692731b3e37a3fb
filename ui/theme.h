// SPDX-License-Identifier: MIT
// The dark theme and the 4-px grid that every size is a multiple of.
#pragma once

namespace svoscope::ui {

/// Sets colours and sizes of the current ImGui context on a fresh style; the font is loaded by the
/// host at the same scale.
void applyTheme(float scale);

/// `units` steps of the 4-px grid in framebuffer pixels.
float grid(float units);

/// `value` pixels at scale 1, for line widths and the like.
float dp(float value);

}  // namespace svoscope::ui
