// SPDX-License-Identifier: MIT
// GL names with an owner: deleted when the owner dies, which must be before the context does.
#pragma once

#include <string>
#include <utility>

#include "ui/render/gl.h"

namespace svoscope::ui {

enum class GlKind { buffer, vertex_array, texture, renderbuffer, framebuffer };

template <GlKind kind>
class GlObject {
 public:
  GlObject() = default;
  explicit GlObject(const Gl& gl) : gl_(&gl) { generate(); }
  ~GlObject() { release(); }
  GlObject(GlObject&& other) noexcept
      : gl_(std::exchange(other.gl_, nullptr)), id_(std::exchange(other.id_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(id_, other.id_);
    return *this;
  }
  GLuint id() const { return id_; }

 private:
  void generate() {
    if constexpr (kind == GlKind::buffer) gl_->GenBuffers(1, &id_);
    if constexpr (kind == GlKind::vertex_array) gl_->GenVertexArrays(1, &id_);
    if constexpr (kind == GlKind::texture) gl_->GenTextures(1, &id_);
    if constexpr (kind == GlKind::renderbuffer) gl_->GenRenderbuffers(1, &id_);
    if constexpr (kind == GlKind::framebuffer) gl_->GenFramebuffers(1, &id_);
  }
  void release() {
    if (!id_) return;
    if constexpr (kind == GlKind::buffer) gl_->DeleteBuffers(1, &id_);
    if constexpr (kind == GlKind::vertex_array) gl_->DeleteVertexArrays(1, &id_);
    if constexpr (kind == GlKind::texture) gl_->DeleteTextures(1, &id_);
    if constexpr (kind == GlKind::renderbuffer) gl_->DeleteRenderbuffers(1, &id_);
    if constexpr (kind == GlKind::framebuffer) gl_->DeleteFramebuffers(1, &id_);
    id_ = 0;
  }

  const Gl* gl_ = nullptr;
  GLuint id_ = 0;
};

using GlBuffer = GlObject<GlKind::buffer>;
using GlVertexArray = GlObject<GlKind::vertex_array>;
using GlTexture = GlObject<GlKind::texture>;
using GlRenderbuffer = GlObject<GlKind::renderbuffer>;
using GlFramebuffer = GlObject<GlKind::framebuffer>;

/// A linked program. Our shaders are constants, so a failure is a defect: it throws
/// std::runtime_error with the driver's log.
class GlProgram {
 public:
  GlProgram(const Gl& gl, const char* name, const char* vertex, const char* fragment);
  ~GlProgram();
  GlProgram(const GlProgram&) = delete;
  GlProgram& operator=(const GlProgram&) = delete;
  GLuint id() const { return id_; }
  GLint uniform(const char* name) const { return gl_.GetUniformLocation(id_, name); }

 private:
  const Gl& gl_;
  GLuint id_ = 0;
};

}  // namespace svoscope::ui
