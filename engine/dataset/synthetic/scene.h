// SPDX-License-Identifier: MIT
// A scene of textured rectangles. World frame: x, y on the floor, z up, metres.
#pragma once

#include <functional>
#include <vector>

#include "engine/base/types.h"
#include "engine/dataset/synthetic/texture.h"

namespace svoscope::synthetic {

/// Points corner + u * edge_u + v * edge_v with u, v in 0..1; (0, 0) is the top left of the
/// texture.
struct Quad {
  Vec3 corner, edge_u, edge_v;
  int texture = 0;
  float gain = 1;  ///< how much light falls on it
};

struct Scene {
  std::vector<Texture> textures;
  std::vector<Quad> quads;
  float sky = 0;           ///< grey level where no quad is; a little darker towards the zenith
  double contrast = 1;     ///< of the textures, see Texture
  double texel_scale = 1;  ///< small images need no fine textures: they are built coarser, faster

  /// Index of a new texture.
  int addTexture(const cv::Mat& image);
  /// A rectangle with `corner` at the texture's top left.
  void addQuad(const Vec3& corner, const Vec3& edge_u, const Vec3& edge_v, int texture,
               float gain = 1);
};

/// Texture index for a face of the given size in metres.
using FaceTexture = std::function<int(double width, double height)>;

/// Five faces of a box that stands on its bottom face: centre of the bottom, size along its own
/// axes, rotation about z in radians. Each face gets a texture of its own.
void addBox(Scene& scene, const Vec3& bottom, const Vec3& size, double yaw,
            const FaceTexture& texture);

}  // namespace svoscope::synthetic
