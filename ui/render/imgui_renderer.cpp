// SPDX-License-Identifier: MIT
#include "ui/render/imgui_renderer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "ui/render/gl_state.h"
#include "ui/render/shaders.h"

namespace svoscope::ui {
namespace {

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

constexpr GLenum kIndexType = sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;

}  // namespace

ImGuiRenderer::ImGuiRenderer(const Gl& gl)
    : gl_(gl),
      program_(gl, "imgui", shaders::imgui_vert, shaders::imgui_frag),
      image_(program_.uniform("image")),
      display_origin_(program_.uniform("display_origin")),
      display_size_(program_.uniform("display_size")),
      vertex_array_(gl),
      vertices_(gl),
      indices_(gl),
      fonts_(gl) {
  ImGuiIO& io = ImGui::GetIO();
  io.BackendRendererName = "svoscope_gl33";
  // Lets ImGui pass 65 536 vertices per draw list with its 16-bit indices.
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;

  gl.BindVertexArray(vertex_array_.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
  const GLsizei stride = sizeof(ImDrawVert);
  for (GLuint attribute : {0u, 1u, 2u}) gl.EnableVertexAttribArray(attribute);
  gl.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, stride, offset(offsetof(ImDrawVert, pos)));
  gl.VertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, stride, offset(offsetof(ImDrawVert, uv)));
  gl.VertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride,
                         offset(offsetof(ImDrawVert, col)));
  gl.BindVertexArray(0);
}

ImGuiRenderer::~ImGuiRenderer() {
  ImGuiIO& io = ImGui::GetIO();
  io.Fonts->SetTexID(nullptr);
  io.BackendRendererName = nullptr;
  io.BackendFlags &= ~ImGuiBackendFlags_RendererHasVtxOffset;
}

void ImGuiRenderer::uploadFonts() {
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  ImGuiIO& io = ImGui::GetIO();
  // One byte a pixel: the shader sees white with this alpha.
  io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
  gl_.BindTexture(GL_TEXTURE_2D, fonts_.id());
  const GLint swizzle[4] = {GL_ONE, GL_ONE, GL_ONE, GL_RED};
  gl_.TexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_RGBA, swizzle);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_.PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, width, height, 0, GL_RED, GL_UNSIGNED_BYTE, pixels);
  io.Fonts->SetTexID(textureId(fonts_.id()));
}

void ImGuiRenderer::render(const ImDrawData& data) {
  const int width = static_cast<int>(data.DisplaySize.x * data.FramebufferScale.x);
  const int height = static_cast<int>(data.DisplaySize.y * data.FramebufferScale.y);
  if (width <= 0 || height <= 0) return;  // minimised
  const GlStateGuard guard(gl_);
  setupState(data, width, height);
  for (int i = 0; i < data.CmdListsCount; ++i) drawList(data, *data.CmdLists[i], width, height);
}

void ImGuiRenderer::setupState(const ImDrawData& data, int width, int height) {
  gl_.Enable(GL_BLEND);
  gl_.BlendEquation(GL_FUNC_ADD);
  // Alpha adds up on its own, so that an opaque background stays opaque.
  gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl_.Disable(GL_CULL_FACE);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.Viewport(0, 0, width, height);
  gl_.UseProgram(program_.id());
  gl_.Uniform1i(image_, 0);
  gl_.Uniform2f(display_origin_, data.DisplayPos.x, data.DisplayPos.y);
  gl_.Uniform2f(display_size_, data.DisplaySize.x, data.DisplaySize.y);
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindSampler(0, 0);
  gl_.BindVertexArray(vertex_array_.id());
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
}

void ImGuiRenderer::drawList(const ImDrawData& data, const ImDrawList& list, int width,
                             int height) {
  gl_.BufferData(GL_ARRAY_BUFFER, list.VtxBuffer.size_in_bytes(), list.VtxBuffer.Data,
                 GL_STREAM_DRAW);
  gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer.size_in_bytes(), list.IdxBuffer.Data,
                 GL_STREAM_DRAW);
  const ImVec2 origin = data.DisplayPos, scale = data.FramebufferScale;
  for (const ImDrawCmd& command : list.CmdBuffer) {
    if (command.UserCallback) {
      if (command.UserCallback == ImDrawCallback_ResetRenderState) {
        setupState(data, width, height);
      } else {
        command.UserCallback(&list, &command);
      }
      continue;
    }
    const int left = std::max(0, static_cast<int>((command.ClipRect.x - origin.x) * scale.x));
    const int top = std::max(0, static_cast<int>((command.ClipRect.y - origin.y) * scale.y));
    const int right = std::min(width, static_cast<int>((command.ClipRect.z - origin.x) * scale.x));
    const int bottom =
        std::min(height, static_cast<int>((command.ClipRect.w - origin.y) * scale.y));
    if (right <= left || bottom <= top) continue;
    gl_.Scissor(left, height - bottom, right - left, bottom - top);  // GL counts rows from below
    gl_.BindTexture(GL_TEXTURE_2D, textureName(command.GetTexID()));
    gl_.DrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount), kIndexType,
                               offset(command.IdxOffset * sizeof(ImDrawIdx)),
                               static_cast<GLint>(command.VtxOffset));
  }
}

}  // namespace svoscope::ui
