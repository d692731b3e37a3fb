// SPDX-License-Identifier: MIT
#include "engine/dataset/synthetic/scene.h"

#include <cmath>

namespace svoscope::synthetic {

int Scene::addTexture(const cv::Mat& image) {
  textures.emplace_back(image, contrast);
  return static_cast<int>(textures.size()) - 1;
}

void Scene::addQuad(const Vec3& corner, const Vec3& edge_u, const Vec3& edge_v, int texture,
                    float gain) {
  quads.push_back({corner, edge_u, edge_v, texture, gain});
}

void addBox(Scene& scene, const Vec3& bottom, const Vec3& size, double yaw,
            const FaceTexture& texture) {
  const Vec3 x(std::cos(yaw), std::sin(yaw), 0), y(-std::sin(yaw), std::cos(yaw), 0);
  const Vec3 z = Vec3::UnitZ();
  const Vec3 half_x = 0.5 * size.x() * x, half_y = 0.5 * size.y() * y, up = size.z() * z;
  // Sides, seen from outside: u to the right, v down. Different light on each makes edges visible.
  const auto side = [&](const Vec3& normal_half, const Vec3& right, double width, float gain) {
    scene.addQuad(bottom + normal_half - 0.5 * width * right + up, width * right, -up,
                  texture(width, size.z()), gain);
  };
  side(half_x, y, size.y(), 0.95f);
  side(-half_x, -y, size.y(), 0.75f);
  side(half_y, -x, size.x(), 0.82f);
  side(-half_y, x, size.x(), 0.88f);
  scene.addQuad(bottom + up - half_x + half_y, 2 * half_x, -2 * half_y, texture(size.x(), size.y()),
                1.12f);
}

}  // namespace svoscope::synthetic
