// SPDX-License-Identifier: MIT
// What panels may ask of the graphics: textures for grey images and small 3-D scenes. Implemented
// once on OpenGL 3.3 core for window and OSMesa, and by a null version without any GL.
#pragma once

#include <imgui/imgui.h>

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "engine/base/types.h"

namespace svoscope::ui {

struct Vertex3 {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();  ///< world, map units
  ImU32 color = 0xffffffff;                            ///< IM_COL32 layout
};

/// A 3-D scene to render. Vertex buffers are uploaded again only when `version` changes; the camera
/// may change every frame at no upload.
struct Scene3 {
  std::uint64_t version = 0;
  std::vector<Vertex3> lines;  ///< pairs
  std::vector<Vertex3> points;
  Eigen::Matrix4f clip_from_world = Eigen::Matrix4f::Identity();
  float point_size_px = 3;
  float line_width_px = 1.5f;
  ImU32 background = 0xff101010;
};

class Graphics {
 public:
  virtual ~Graphics() = default;
  /// Texture of a CV_8UC1 or CV_8UC3 (RGB) image. `slot` names the place on screen and owns the
  /// texture; uploaded only when `version` (for example the frame index) or the size changes.
  virtual ImTextureID image(std::uint32_t slot, const cv::Mat& pixels, std::uint64_t version,
                            bool smooth) = 0;
  /// Texture of a rendered scene, `width` x `height` framebuffer pixels, row 0 at the top when
  /// drawn with ImGui's default uv.
  virtual ImTextureID scene(std::uint32_t slot, const Scene3& scene, int width, int height) = 0;
};

}  // namespace svoscope::ui
