// SPDX-License-Identifier: MIT
#include "ui/render/gl.h"

#include <string>

namespace svoscope::ui {
namespace {

std::string text(const Gl& gl, GLenum name) {
  const GLubyte* bytes = gl.GetString(name);
  return bytes ? reinterpret_cast<const char*>(bytes) : "unknown";
}

}  // namespace

Result<Gl> loadGl(const GetGlProc& get_proc) {
  Gl gl;
#define SVOSCOPE_GL_LOAD(type, name)                                          \
  gl.name = reinterpret_cast<type>(get_proc("gl" #name));                     \
  if (!gl.name)                                                               \
    return Error{ErrorKind::internal, "the driver has no gl" #name, "OpenGL", \
                 "OpenGL 3.3 core is needed; update Mesa or use --headless"};
  SVOSCOPE_GL_FUNCTIONS(SVOSCOPE_GL_LOAD)
#undef SVOSCOPE_GL_LOAD
  GLint major = 0, minor = 0;
  gl.GetIntegerv(GL_MAJOR_VERSION, &major);
  gl.GetIntegerv(GL_MINOR_VERSION, &minor);
  if (major * 10 + minor < 33) {
    return Error{ErrorKind::internal,
                 "OpenGL " + std::to_string(major) + "." + std::to_string(minor) + " is too old",
                 text(gl, GL_RENDERER), "3.3 core is needed; LIBGL_ALWAYS_SOFTWARE=1 may help"};
  }
  return gl;
}

std::string glDescription(const Gl& gl) {
  return text(gl, GL_RENDERER) + ", OpenGL " + text(gl, GL_VERSION);
}

bool isSoftwareRenderer(const Gl& gl) {
  const std::string renderer = text(gl, GL_RENDERER);
  for (const char* name :
       {"llvmpipe", "softpipe", "swrast", "Software Rasterizer", "SwiftShader"}) {
    if (renderer.find(name) != std::string::npos) return true;
  }
  return false;
}

}  // namespace svoscope::ui
