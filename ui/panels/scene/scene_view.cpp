// SPDX-License-Identifier: MIT
#include "ui/panels/scene/scene_view.h"

#include <algorithm>
#include <cmath>

#include "ui/palette.h"
#include "ui/theme.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/probe.h"

namespace svoscope::ui {

namespace {

void navigate(SceneOptions& o, const SceneCamera& camera, bool hovered, bool active) {
  const ImGuiIO& io = ImGui::GetIO();
  if (hovered && io.MouseWheel != 0) {
    o.distance = std::clamp(o.distance * std::pow(0.87, io.MouseWheel), 1e-3, 1e6);
    o.fitted = true;
  }
  if (!active) return;
  const bool panning = ImGui::IsMouseDown(1) || ImGui::IsMouseDown(2) || io.KeyShift;
  if (io.MouseDelta.x == 0 && io.MouseDelta.y == 0) return;
  if (panning) {
    const double k = o.distance * 0.9 / std::max(1.0f, camera.hi.y - camera.lo.y);
    o.target += k * (-io.MouseDelta.x * camera.right + io.MouseDelta.y * camera.up);
    o.follow = false;
  } else if (ImGui::IsMouseDragging(0, 3)) {
    o.yaw -= io.MouseDelta.x * 0.006;
    o.pitch = std::clamp(o.pitch + io.MouseDelta.y * 0.006, -1.5707, 1.5707);
  }
  o.fitted = true;
}

}  // namespace

double sceneAspect() {
  const ImVec2 room = ImGui::GetContentRegionAvail();
  return std::max(room.x, 4.0f) / std::max(room.y, 4.0f);
}

SceneArea sceneArea(const char* label, SceneOptions& options) {
  const ImVec2 avail = ImGui::GetContentRegionAvail();
  const ImVec2 room{std::max(avail.x, 4.0f), std::max(avail.y, 4.0f)};
  SceneArea area;
  area.lo = ImGui::GetCursorScreenPos();
  area.hi = {area.lo.x + room.x, area.lo.y + room.y};
  ImGui::InvisibleButton("##scene", room,
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  Probe::record(label, area.lo, area.hi);
  const bool hovered = ImGui::IsItemHovered(), active = ImGui::IsItemActive();
  const ImVec2 drag = ImGui::GetMouseDragDelta(0, 0);
  area.clicked = ImGui::IsItemDeactivated() && hovered && std::hypot(drag.x, drag.y) < 4;
  navigate(options, makeSceneCamera(options, area.lo, area.hi), hovered, active);
  area.camera = makeSceneCamera(options, area.lo, area.hi);
  return area;
}

void sceneLegend(ImVec2& at, Swatch kind, ImU32 color, const std::string& text) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float width = ImGui::CalcTextSize(text.c_str()).x,
              line = ImGui::GetTextLineHeight() + grid(0.5f);
  list->AddRectFilled({at.x - grid(1), at.y}, {at.x + grid(5) + width, at.y + line},
                      IM_COL32(0, 0, 0, 110));
  drawSwatch(kind, {at.x + grid(1.5f), at.y + ImGui::GetTextLineHeight() / 2}, grid(1), color);
  list->AddText({at.x + grid(4), at.y}, ink::text, text.c_str());
  at.y += line;
}

void drawGizmo(const SceneCamera& camera) {
  const float r = grid(6);
  if (camera.hi.y - camera.lo.y < 5 * r) return;
  const ImVec2 o{camera.lo.x + r + grid(2), camera.hi.y - r - grid(2)};
  struct AxisInk {
    Vec3 direction;
    ImU32 color;
    const char* name;
  };
  const AxisInk axes[] = {{Vec3::UnitX(), okabe::vermillion, "x"},
                          {Vec3::UnitY(), okabe::green, "y"},
                          {Vec3::UnitZ(), okabe::sky, "z"}};
  ImDrawList* list = ImGui::GetWindowDrawList();
  for (const AxisInk& a : axes) {
    const auto x = static_cast<float>(a.direction.dot(camera.right));
    const auto y = static_cast<float>(-a.direction.dot(camera.up));
    const ImVec2 e{o.x + x * r * 0.8f, o.y + y * r * 0.8f};
    list->AddLine(o, e, a.color, dp(2));
    outlinedText(
        list, {e.x + x * grid(1.5f) - grid(0.75f), e.y + y * grid(1.5f) - ImGui::GetFontSize() / 2},
        a.color, a.name);
  }
}

void circleAt(const SceneCamera& camera, const Vec3& p, ImU32 color) {
  const auto at = camera.project(p);
  if (!at) return;
  ImGui::GetWindowDrawList()->AddCircle(*at, dp(7), IM_COL32(0, 0, 0, 180), 20, dp(4));
  ImGui::GetWindowDrawList()->AddCircle(*at, dp(7), color, 20, dp(2));
}

}  // namespace svoscope::ui
