// SPDX-License-Identifier: MIT
// Sources of shaders/*.glsl, compiled into the program by shaders/CMakeLists.txt.
#pragma once

namespace svoscope::ui::shaders {

extern const char* const imgui_vert;
extern const char* const imgui_frag;
extern const char* const line_vert;
extern const char* const line_frag;
extern const char* const point_vert;
extern const char* const point_frag;

}  // namespace svoscope::ui::shaders
