// SPDX-License-Identifier: MIT
#include "ui/render/gl_state.h"

namespace svoscope::ui {

GlStateGuard::GlStateGuard(const Gl& gl) : gl_(gl) {
  for (int i = 0; i < 5; ++i) switches_[i] = gl.IsEnabled(kSwitches[i]);
  gl.GetIntegerv(GL_CURRENT_PROGRAM, &program_);
  gl.GetIntegerv(GL_VERTEX_ARRAY_BINDING, &vertex_array_);
  gl.GetIntegerv(GL_ARRAY_BUFFER_BINDING, &array_buffer_);
  gl.GetIntegerv(GL_ACTIVE_TEXTURE, &active_texture_);
  gl.GetIntegerv(GL_TEXTURE_BINDING_2D, &texture_);
  gl.GetIntegerv(GL_FRAMEBUFFER_BINDING, &framebuffer_);
  gl.GetIntegerv(GL_VIEWPORT, viewport_);
  gl.GetIntegerv(GL_SCISSOR_BOX, scissor_);
  gl.GetIntegerv(GL_BLEND_SRC_RGB, &source_rgb_);
  gl.GetIntegerv(GL_BLEND_DST_RGB, &target_rgb_);
  gl.GetIntegerv(GL_BLEND_SRC_ALPHA, &source_alpha_);
  gl.GetIntegerv(GL_BLEND_DST_ALPHA, &target_alpha_);
  gl.GetIntegerv(GL_BLEND_EQUATION_RGB, &equation_rgb_);
  gl.GetIntegerv(GL_BLEND_EQUATION_ALPHA, &equation_alpha_);
}

GlStateGuard::~GlStateGuard() {
  for (int i = 0; i < 5; ++i) (switches_[i] ? gl_.Enable : gl_.Disable)(kSwitches[i]);
  gl_.UseProgram(program_);
  gl_.BindVertexArray(vertex_array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, array_buffer_);
  gl_.ActiveTexture(active_texture_);
  gl_.BindTexture(GL_TEXTURE_2D, texture_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.Viewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
  gl_.Scissor(scissor_[0], scissor_[1], scissor_[2], scissor_[3]);
  gl_.BlendFuncSeparate(source_rgb_, target_rgb_, source_alpha_, target_alpha_);
  gl_.BlendEquationSeparate(equation_rgb_, equation_alpha_);
}

}  // namespace svoscope::ui
