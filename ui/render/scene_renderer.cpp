// SPDX-License-Identifier: MIT
#include "ui/render/scene_renderer.h"

#include <cstddef>

#include "ui/render/gl_state.h"
#include "ui/render/shaders.h"

namespace svoscope::ui {
namespace {

static_assert(sizeof(Vertex3) == 16, "the attributes below assume 3 floats and 4 bytes");

void vertexAttributes(const Gl& gl, GLuint first, GLsizei stride, std::size_t start,
                      GLuint divisor) {
  const auto offset = [&](std::size_t bytes) {
    return reinterpret_cast<const void*>(start + bytes);
  };
  gl.VertexAttribPointer(first, 3, GL_FLOAT, GL_FALSE, stride, offset(0));
  gl.VertexAttribPointer(first + 1, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride, offset(12));
  for (GLuint attribute : {first, first + 1}) {
    gl.EnableVertexAttribArray(attribute);
    gl.VertexAttribDivisor(attribute, divisor);
  }
}

void clear(const Gl& gl, ImU32 color) {
  const ImVec4 c = ImGui::ColorConvertU32ToFloat4(color);
  gl.ClearColor(c.x, c.y, c.z, c.w);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

}  // namespace

SceneSlot::SceneSlot(const Gl& gl)
    : target(gl, true), line_array(gl), point_array(gl), line_vertices(gl), point_vertices(gl) {
  const GlStateGuard guard(gl);
  gl.BindVertexArray(line_array.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, line_vertices.id());
  // An instance is a line: its two ends are neighbours in the buffer.
  vertexAttributes(gl, 0, 2 * sizeof(Vertex3), 0, 1);
  vertexAttributes(gl, 2, 2 * sizeof(Vertex3), sizeof(Vertex3), 1);
  gl.BindVertexArray(point_array.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, point_vertices.id());
  vertexAttributes(gl, 0, sizeof(Vertex3), 0, 0);
}

bool SceneSlot::View::operator==(const View& other) const {
  return version == other.version && clip_from_world == other.clip_from_world &&
         point_size_px == other.point_size_px && line_width_px == other.line_width_px &&
         background == other.background && width == other.width && height == other.height;
}

SceneRenderer::SceneRenderer(const Gl& gl)
    : gl_(gl),
      line_program_(gl, "line", shaders::line_vert, shaders::line_frag),
      point_program_(gl, "point", shaders::point_vert, shaders::point_frag) {
  line_ = {line_program_.uniform("clip_from_world"), line_program_.uniform("viewport"),
           line_program_.uniform("width")};
  point_ = {point_program_.uniform("clip_from_world"), point_program_.uniform("size")};
}

void SceneRenderer::render(SceneSlot& slot, const Scene3& scene, int width, int height) {
  const SceneSlot::View view{scene.version,
                             scene.clip_from_world,
                             scene.point_size_px,
                             scene.line_width_px,
                             scene.background,
                             width,
                             height};
  if (slot.filled && slot.view == view) return;
  const GlStateGuard guard(gl_);
  if (!slot.filled || slot.view.version != scene.version) upload(slot, scene);
  slot.target.begin(width, height);
  gl_.Disable(GL_SCISSOR_TEST);
  clear(gl_, scene.background);
  draw(slot, scene);
  slot.view = view;
  slot.filled = true;
}

void SceneRenderer::upload(SceneSlot& slot, const Scene3& scene) {
  const auto fill = [&](const GlBuffer& buffer, const std::vector<Vertex3>& vertices) {
    gl_.BindBuffer(GL_ARRAY_BUFFER, buffer.id());
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex3)),
                   vertices.data(), GL_DYNAMIC_DRAW);
  };
  fill(slot.line_vertices, scene.lines);
  fill(slot.point_vertices, scene.points);
  slot.line_count = static_cast<GLsizei>(scene.lines.size() / 2);
  slot.point_count = static_cast<GLsizei>(scene.points.size());
}

void SceneRenderer::draw(const SceneSlot& slot, const Scene3& scene) {
  gl_.Enable(GL_BLEND);
  gl_.BlendEquation(GL_FUNC_ADD);
  gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthFunc(GL_LEQUAL);  // flat scenes: what comes later is on top
  gl_.Enable(GL_PROGRAM_POINT_SIZE);
  gl_.Disable(GL_CULL_FACE);
  const float* matrix = scene.clip_from_world.data();
  if (slot.line_count > 0) {
    gl_.UseProgram(line_program_.id());
    gl_.UniformMatrix4fv(line_.matrix, 1, GL_FALSE, matrix);
    gl_.Uniform2f(line_.viewport, static_cast<float>(slot.target.width()),
                  static_cast<float>(slot.target.height()));
    gl_.Uniform1f(line_.width, scene.line_width_px);
    gl_.BindVertexArray(slot.line_array.id());
    gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, slot.line_count);
  }
  if (slot.point_count > 0) {
    gl_.UseProgram(point_program_.id());
    gl_.UniformMatrix4fv(point_.matrix, 1, GL_FALSE, matrix);
    gl_.Uniform1f(point_.size, scene.point_size_px);
    gl_.BindVertexArray(slot.point_array.id());
    gl_.DrawArrays(GL_POINTS, 0, slot.point_count);
  }
}

}  // namespace svoscope::ui
