// SPDX-License-Identifier: MIT
// The window on a display, through GLFW. The only place that knows GLFW.
#pragma once

#include <memory>

#include "ui/surface/surface.h"

namespace svoscope::ui {

Result<std::unique_ptr<Surface>> makeWindowSurface(SurfaceSize size, float scale);

}  // namespace svoscope::ui
