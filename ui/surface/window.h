// SPDX-License-Identifier: MIT
// The window on a display, through GLFW. The only place that knows GLFW.
#pragma once

#include <memory>

#include "ui/surface/surface.h"

namespace svoscope::ui {

Result<std::unique_ptr<Surface>> makeWindowSurface(SurfaceSize size, float scale);

/// What DISPLAY or WAYLAND_DISPLAY says; empty if neither is set.
std::string displayName();
/// That a window cannot be opened, with the ways to go without: a matter of use, whatever the
/// cause.
Error displayError(std::string what);

}  // namespace svoscope::ui
