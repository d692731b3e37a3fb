// SPDX-License-Identifier: MIT
#include "ui/render/render_target.h"

#include <algorithm>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <string>

namespace svoscope::ui {

void RenderTarget::begin(int width, int height) {
  width = std::max(width, 1);
  height = std::max(height, 1);
  if (width != width_ || height != height_) allocate(width, height);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  gl_->Viewport(0, 0, width_, height_);
}

void RenderTarget::allocate(int width, int height) {
  if (!framebuffer_.id()) {
    color_ = GlTexture(*gl_);
    framebuffer_ = GlFramebuffer(*gl_);
    if (with_depth_) depth_ = GlRenderbuffer(*gl_);
  }
  gl_->BindTexture(GL_TEXTURE_2D, color_.id());
  gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  for (GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl_->TexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  for (GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl_->TexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  gl_->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_.id(), 0);
  if (with_depth_) {
    gl_->BindRenderbuffer(GL_RENDERBUFFER, depth_.id());
    gl_->RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
    gl_->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.id());
  }
  if (gl_->CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error("the driver refuses a picture of " + std::to_string(width) + " x " +
                             std::to_string(height) + " pixels");
  }
  width_ = width;
  height_ = height;
}

cv::Mat RenderTarget::readPixels() const {
  cv::Mat bottom_up(height_, width_, CV_8UC3), top_down;
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  gl_->PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl_->ReadPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, bottom_up.data);
  end();
  cv::flip(bottom_up, top_down, 0);
  return top_down;
}

void RenderTarget::blitToWindow(int width, int height) const {
  gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.id());
  gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  const bool same = width == width_ && height == height_;
  gl_->BlitFramebuffer(0, 0, width_, height_, 0, 0, width, height, GL_COLOR_BUFFER_BIT,
                       same ? GL_NEAREST : GL_LINEAR);
  end();
}

}  // namespace svoscope::ui
