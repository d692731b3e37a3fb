// SPDX-License-Identifier: MIT
// The panels' graphics on OpenGL 3.3 core.
#pragma once

#include <map>
#include <memory>

#include "ui/render/graphics.h"
#include "ui/render/image_texture.h"
#include "ui/render/scene_renderer.h"

namespace svoscope::ui {

class GlGraphics : public Graphics {
 public:
  explicit GlGraphics(const Gl& gl) : gl_(gl), scene_renderer_(gl) {}

  ImTextureID image(std::uint32_t slot, const cv::Mat& pixels, std::uint64_t version,
                    bool smooth) override;
  ImTextureID scene(std::uint32_t slot, const Scene3& scene, int width, int height) override;

 private:
  const Gl& gl_;
  SceneRenderer scene_renderer_;
  // Slots are places on screen: there are few, and they live as long as the window.
  std::map<std::uint32_t, ImageTexture> images_;
  std::map<std::uint32_t, SceneSlot> scenes_;
};

}  // namespace svoscope::ui
