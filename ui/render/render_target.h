// SPDX-License-Identifier: MIT
// An off-screen picture to render into: the whole UI, or one 3-D scene. Everything is drawn here
// first, so window, screenshots and headless runs get the same pixels.
#pragma once

#include <opencv2/core/mat.hpp>

#include "ui/render/gl_object.h"

namespace svoscope::ui {

class RenderTarget {
 public:
  explicit RenderTarget(const Gl& gl, bool with_depth = false)
      : gl_(&gl), with_depth_(with_depth) {}

  /// Makes it the current framebuffer of `width` x `height` pixels and sets the viewport.
  void begin(int width, int height);
  /// Back to the window's own framebuffer.
  void end() const { gl_->BindFramebuffer(GL_FRAMEBUFFER, 0); }

  GLuint texture() const { return color_.id(); }
  int width() const { return width_; }
  int height() const { return height_; }

  /// RGB, row 0 at the top, of a picture drawn the usual GL way (y up).
  cv::Mat readPixels() const;
  /// Copies to the window's framebuffer of the given size.
  void blitToWindow(int width, int height) const;

 private:
  void allocate(int width, int height);

  const Gl* gl_;
  bool with_depth_;
  int width_ = 0, height_ = 0;
  GlTexture color_;
  GlRenderbuffer depth_;
  GlFramebuffer framebuffer_;
};

}  // namespace svoscope::ui
