// SPDX-License-Identifier: MIT
// A zoomable image with a transform for crisp overlays. Image coordinates are pixels of level 0
// with pixel centres at integers.
#pragma once

#include <imgui/imgui.h>

#include "engine/base/types.h"

namespace svoscope::ui {

using Px = Eigen::Vector2f;

struct ImageViewState {
  float zoom = 0;          ///< screen pixels per image pixel; 0: fit
  Px center = Px::Zero();  ///< image pixel in the middle of the view
};

struct ImageView {
  ImVec2 lo, hi;  ///< area on screen
  float zoom = 1;
  Px center = Px::Zero();
  bool hovered = false;
  bool clicked = false;  ///< released without dragging
  Px mouse = Px::Zero();

  ImVec2 toScreen(const Px& px) const {
    return {(lo.x + hi.x) / 2 + (px.x() - center.x()) * zoom,
            (lo.y + hi.y) / 2 + (px.y() - center.y()) * zoom};
  }
  Px toImage(ImVec2 p) const {
    return {(p.x - (lo.x + hi.x) / 2) / zoom + center.x(),
            (p.y - (lo.y + hi.y) / 2) / zoom + center.y()};
  }
  bool onScreen(ImVec2 p, float margin) const {
    return p.x > lo.x - margin && p.y > lo.y - margin && p.x < hi.x + margin && p.y < hi.y + margin;
  }
};

/// Zoom that shows the whole image.
float fitZoom(int width, int height, ImVec2 room);

/// Handles zoom at the cursor, pan and fit (double-click) over the remaining room.
ImageView imageViewArea(const char* label, ImageViewState& state, int width, int height);
/// Draws the texture of a `width` x `height` image (any pyramid level stretches over it).
void drawImage(const ImageView& view, ImTextureID texture, int width, int height);
/// Zooms about the centre of the view; used by the + and - keys.
void zoomImage(ImageViewState& state, float fit, float factor);

}  // namespace svoscope::ui
