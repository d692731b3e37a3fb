// SPDX-License-Identifier: MIT
// Draws ImGui's draw lists with our GL table into the current framebuffer. Our own instead of the
// packaged backend, because that one loads libGL itself and so cannot run on OSMesa.
#pragma once

#include <imgui/imgui.h>

#include "ui/render/gl_object.h"

namespace svoscope::ui {

class ImGuiRenderer {
 public:
  /// Announces what we can do in io; needs a current context.
  explicit ImGuiRenderer(const Gl& gl);
  ~ImGuiRenderer();
  ImGuiRenderer(const ImGuiRenderer&) = delete;
  ImGuiRenderer& operator=(const ImGuiRenderer&) = delete;

  /// Uploads the font atlas; again whenever it was rebuilt.
  void uploadFonts();
  void render(const ImDrawData& data);

 private:
  void setupState(const ImDrawData& data, int width, int height);
  void drawList(const ImDrawData& data, const ImDrawList& list, int width, int height);

  const Gl& gl_;
  GlProgram program_;
  GLint image_, display_origin_, display_size_;
  GlVertexArray vertex_array_;
  GlBuffer vertices_, indices_;
  GlTexture fonts_;
};

/// ImGui's opaque texture handles are GL texture names here.
inline ImTextureID textureId(GLuint texture) {
  return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture));
}
inline GLuint textureName(ImTextureID id) {
  return static_cast<GLuint>(reinterpret_cast<std::uintptr_t>(id));
}

}  // namespace svoscope::ui
