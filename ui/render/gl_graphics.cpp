// SPDX-License-Identifier: MIT
#include "ui/render/gl_graphics.h"

#include "ui/render/imgui_renderer.h"

namespace svoscope::ui {

ImTextureID GlGraphics::image(std::uint32_t slot, const cv::Mat& pixels, std::uint64_t version,
                              bool smooth) {
  ImageTexture& texture = images_.try_emplace(slot, gl_).first->second;
  texture.update(pixels, version, smooth);
  return textureId(texture.id());
}

ImTextureID GlGraphics::scene(std::uint32_t slot, const Scene3& scene, int width, int height) {
  SceneSlot& place = scenes_.try_emplace(slot, gl_).first->second;
  scene_renderer_.render(place, scene, width, height);
  return textureId(place.target.texture());
}

}  // namespace svoscope::ui
