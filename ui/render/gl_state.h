// SPDX-License-Identifier: MIT
// Puts the GL state back that drawing changes, so that renderers do not depend on their order.
#pragma once

#include "ui/render/gl.h"

namespace svoscope::ui {

class GlStateGuard {
 public:
  explicit GlStateGuard(const Gl& gl);
  ~GlStateGuard();
  GlStateGuard(const GlStateGuard&) = delete;
  GlStateGuard& operator=(const GlStateGuard&) = delete;

 private:
  static constexpr GLenum kSwitches[] = {GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST, GL_SCISSOR_TEST,
                                         GL_PROGRAM_POINT_SIZE};
  const Gl& gl_;
  bool switches_[5];
  GLint program_, vertex_array_, array_buffer_, active_texture_, texture_, framebuffer_;
  GLint viewport_[4], scissor_[4];
  GLint source_rgb_, target_rgb_, source_alpha_, target_alpha_, equation_rgb_, equation_alpha_;
};

}  // namespace svoscope::ui
