// SPDX-License-Identifier: MIT
#include "ui/surface/surface.h"

#include <cstdlib>
#include <utility>

#include "ui/surface/headless.h"
#include "ui/surface/window.h"

namespace svoscope::ui {

std::string displayName() {
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY"}) {
    const char* value = std::getenv(name);
    if (value && *value) return value;
  }
  return "";
}

Error displayError(std::string what) {
  return usageError(
      std::move(what), "window",
      "set DISPLAY to one that is there, start one by xvfb-run svoscope SEQUENCE, or use "
      "--headless to render without a window");
}

Result<std::unique_ptr<Surface>> makeSurface(SurfaceKind kind, SurfaceSize size, float scale) {
  switch (kind) {
    case SurfaceKind::osmesa:
      return makeOsmesaSurface(size, scale);
    case SurfaceKind::null:
      return std::unique_ptr<Surface>(std::make_unique<NullSurface>(size, scale));
    case SurfaceKind::automatic:
    case SurfaceKind::window:
      break;
  }
  if (displayName().empty())
    return displayError("there is no display to open a window on: DISPLAY is not set");
  return makeWindowSurface(size, scale);
}

}  // namespace svoscope::ui
