// SPDX-License-Identifier: MIT
// What every 3-D view has: an area that orbits, pans and zooms, and its axes.
#pragma once

#include <string>

#include "ui/panels/scene/scene_camera.h"
#include "ui/widgets/controls.h"

namespace svoscope::ui {

struct SceneArea {
  SceneCamera camera;
  ImVec2 lo, hi;
  bool clicked = false;  ///< released without dragging

  int width() const { return static_cast<int>(hi.x - lo.x); }
  int height() const { return static_cast<int>(hi.y - lo.y); }
};

/// Takes the remaining room and moves the viewpoint by the mouse.
SceneArea sceneArea(const char* label, SceneOptions& options);
/// Width over height of the remaining room.
double sceneAspect();

/// The three axes in the lower left corner.
void drawGizmo(const SceneCamera& camera);
void circleAt(const SceneCamera& camera, const Vec3& p, ImU32 color);

/// Swatch and text on a dark ground; `at` moves to the next line.
void sceneLegend(ImVec2& at, Swatch kind, ImU32 color, const std::string& text);

}  // namespace svoscope::ui
