// SPDX-License-Identifier: MIT
// Points and lines of a Scene3 into a texture. Edges are smoothed in the shaders: as good as 4x
// multisampling for these shapes, and far cheaper on a software renderer.
#pragma once

#include <optional>

#include "ui/render/graphics.h"
#include "ui/render/render_target.h"

namespace svoscope::ui {

/// What one place on screen keeps between frames.
struct SceneSlot {
  explicit SceneSlot(const Gl& gl);

  RenderTarget target;
  GlVertexArray line_array, point_array;
  GlBuffer line_vertices, point_vertices;
  GLsizei line_count = 0, point_count = 0;
  bool filled = false;

  /// Everything the picture depends on: an unchanged view costs nothing.
  struct View {
    std::uint64_t version = 0;
    Eigen::Matrix4f clip_from_world;
    float point_size_px = 0, line_width_px = 0;
    ImU32 background = 0;
    int width = 0, height = 0;
    bool operator==(const View& other) const;
  } view;
};

class SceneRenderer {
 public:
  explicit SceneRenderer(const Gl& gl);
  void render(SceneSlot& slot, const Scene3& scene, int width, int height);

 private:
  void upload(SceneSlot& slot, const Scene3& scene);
  void draw(const SceneSlot& slot, const Scene3& scene);

  const Gl& gl_;
  GlProgram line_program_, point_program_;
  struct {
    GLint matrix, viewport, width;
  } line_;
  struct {
    GLint matrix, size;
  } point_;
};

}  // namespace svoscope::ui
