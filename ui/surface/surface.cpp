// SPDX-License-Identifier: MIT
#include "ui/surface/surface.h"

#include <cstdlib>

#include "ui/surface/headless.h"
#include "ui/surface/window.h"

namespace svoscope::ui {
namespace {

bool displayExists() {
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY"}) {
    const char* value = std::getenv(name);
    if (value && *value) return true;
  }
  return false;
}

}  // namespace

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
  if (!displayExists()) {
    return Error{ErrorKind::usage, "there is no display to open a window on", "window",
                 "set DISPLAY, or use --headless to render without one"};
  }
  return makeWindowSurface(size, scale);
}

}  // namespace svoscope::ui
