// SPDX-License-Identifier: MIT
#include "ui/widgets/image_view.h"

#include <algorithm>
#include <cmath>

#include "ui/palette.h"
#include "ui/widgets/probe.h"

namespace svoscope::ui {

namespace {

constexpr float kMaxZoom = 64;

void pan(ImageViewState& state, const ImageView& view) {
  const ImVec2 by = ImGui::GetIO().MouseDelta;
  if (by.x == 0 && by.y == 0) return;
  state.zoom = view.zoom;
  state.center = view.center - Px(by.x, by.y) / view.zoom;
}

// The image pixel under the cursor stays there.
void zoomAtCursor(ImageViewState& state, const ImageView& view, float fit) {
  const ImGuiIO& io = ImGui::GetIO();
  const float zoom =
      std::clamp(view.zoom * std::pow(1.2f, io.MouseWheel), 0.5f * fit, std::max(kMaxZoom, fit));
  const Px under = view.toImage(io.MousePos);
  state.center = under + (view.center - under) * (view.zoom / zoom);
  state.zoom = zoom;
}

void apply(const ImageViewState& state, ImageView& view, float fit, int width, int height) {
  view.zoom = state.zoom > 0 ? state.zoom : fit;
  view.center = state.zoom > 0
                    ? state.center
                    : Px((static_cast<float>(width) - 1) / 2, (static_cast<float>(height) - 1) / 2);
}

}  // namespace

float fitZoom(int width, int height, ImVec2 room) {
  if (width < 1 || height < 1) return 1;
  return std::max(
      0.02f, std::min(room.x / static_cast<float>(width), room.y / static_cast<float>(height)));
}

void zoomImage(ImageViewState& state, float fit, float factor) {
  const float zoom = (state.zoom > 0 ? state.zoom : fit) * factor;
  state.zoom = zoom <= fit ? 0 : std::min(zoom, kMaxZoom);
}

ImageView imageViewArea(const char* label, ImageViewState& state, int width, int height) {
  ImVec2 room = ImGui::GetContentRegionAvail();
  room = {std::max(room.x, 4.0f), std::max(room.y, 4.0f)};
  ImageView view;
  view.lo = ImGui::GetCursorScreenPos();
  view.hi = {view.lo.x + room.x, view.lo.y + room.y};
  const float fit = fitZoom(width, height, room);
  apply(state, view, fit, width, height);
  ImGui::InvisibleButton("##view", room);
  Probe::record(label, view.lo, view.hi);
  view.hovered = ImGui::IsItemHovered();
  if (view.hovered && ImGui::GetIO().MouseWheel != 0) zoomAtCursor(state, view, fit);
  if (ImGui::IsItemActive() && ImGui::IsMouseDragging(0, 4)) pan(state, view);
  const ImVec2 drag = ImGui::GetMouseDragDelta(0, 0);
  view.clicked = ImGui::IsItemDeactivated() && view.hovered && std::hypot(drag.x, drag.y) < 4;
  if (view.hovered && ImGui::IsMouseDoubleClicked(0)) state.zoom = 0;
  if (state.zoom == 0)
    state.center = Px((static_cast<float>(width) - 1) / 2, (static_cast<float>(height) - 1) / 2);
  apply(state, view, fit, width, height);
  view.mouse = view.toImage(ImGui::GetIO().MousePos);
  return view;
}

void drawImage(const ImageView& view, ImTextureID texture, int width, int height) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(view.lo, view.hi, ink::canvas);
  const ImVec2 a = view.toScreen({-0.5f, -0.5f});
  const ImVec2 b =
      view.toScreen({static_cast<float>(width) - 0.5f, static_cast<float>(height) - 0.5f});
  list->PushClipRect(view.lo, view.hi, true);
  if (texture) list->AddImage(texture, a, b);
  list->PopClipRect();
}

}  // namespace svoscope::ui
