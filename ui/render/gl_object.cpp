// SPDX-License-Identifier: MIT
#include "ui/render/gl_object.h"

#include <stdexcept>

namespace svoscope::ui {
namespace {

GLuint compile(const Gl& gl, GLenum stage, const char* name, const char* source) {
  const GLuint shader = gl.CreateShader(stage);
  gl.ShaderSource(shader, 1, &source, nullptr);
  gl.CompileShader(shader);
  GLint compiled = 0;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (!compiled) {
    char log[2048] = "";
    gl.GetShaderInfoLog(shader, sizeof log, nullptr, log);
    gl.DeleteShader(shader);
    throw std::runtime_error(std::string("shader ") + name + " does not compile: " + log);
  }
  return shader;
}

}  // namespace

GlProgram::GlProgram(const Gl& gl, const char* name, const char* vertex, const char* fragment)
    : gl_(gl) {
  const GLuint stages[2] = {compile(gl, GL_VERTEX_SHADER, name, vertex),
                            compile(gl, GL_FRAGMENT_SHADER, name, fragment)};
  id_ = gl.CreateProgram();
  for (GLuint stage : stages) gl.AttachShader(id_, stage);
  gl.LinkProgram(id_);
  for (GLuint stage : stages) gl.DeleteShader(stage);
  GLint linked = 0;
  gl.GetProgramiv(id_, GL_LINK_STATUS, &linked);
  if (!linked) {
    char log[2048] = "";
    gl.GetProgramInfoLog(id_, sizeof log, nullptr, log);
    gl.DeleteProgram(id_);
    throw std::runtime_error(std::string("program ") + name + " does not link: " + log);
  }
}

GlProgram::~GlProgram() { gl_.DeleteProgram(id_); }

}  // namespace svoscope::ui
