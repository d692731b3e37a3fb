// SPDX-License-Identifier: MIT
// The orbiting camera of the 3-D view. The world is the first camera's frame: y points down.
#pragma once

#include <imgui/imgui.h>

#include <optional>

#include "ui/model/ui_state.h"

namespace svoscope::ui {

struct SceneCamera {
  Mat4 clip_from_world = Mat4::Identity();
  Vec3 right = Vec3::UnitX(), up = -Vec3::UnitY(), forward = Vec3::UnitZ();
  ImVec2 lo, hi;

  /// Screen position; nothing behind the camera.
  std::optional<ImVec2> project(const Vec3& world) const;
};

/// Camera that looks at options.target from options.distance.
SceneCamera makeSceneCamera(const SceneOptions& options, ImVec2 lo, ImVec2 hi);
/// Target and distance that show a ball around `center`.
void fitScene(SceneOptions& options, const Vec3& center, double radius, double aspect);
void topView(SceneOptions& options);

}  // namespace svoscope::ui
