// SPDX-License-Identifier: MIT
#include "ui/panels/scene/scene_camera.h"

#include <algorithm>
#include <cmath>

namespace svoscope::ui {

namespace {

constexpr double kHalfAngle = 0.42;  // of the vertical field of view, radians

Mat4 perspective(double aspect, double near_z, double far_z) {
  const double f = 1 / std::tan(kHalfAngle);
  Mat4 P = Mat4::Zero();
  P(0, 0) = f / std::max(aspect, 1e-3);
  P(1, 1) = f;
  P(2, 2) = (far_z + near_z) / (near_z - far_z);
  P(2, 3) = 2 * far_z * near_z / (near_z - far_z);
  P(3, 2) = -1;
  return P;
}

}  // namespace

SceneCamera makeSceneCamera(const SceneOptions& o, ImVec2 lo, ImVec2 hi) {
  SceneCamera camera;
  camera.lo = lo;
  camera.hi = hi;
  const double cy = std::cos(o.yaw), sy = std::sin(o.yaw);
  const double cp = std::cos(o.pitch), sp = std::sin(o.pitch);
  camera.forward = Vec3(sy * cp, sp, cy * cp);  // pitch > 0 looks down: y is down
  camera.right = Vec3(cy, 0, -sy);
  camera.up = camera.right.cross(camera.forward);
  const Vec3 eye = o.target - o.distance * camera.forward;
  Mat4 view = Mat4::Identity();
  view.block<1, 3>(0, 0) = camera.right.transpose();
  view.block<1, 3>(1, 0) = camera.up.transpose();
  view.block<1, 3>(2, 0) = -camera.forward.transpose();
  view.block<3, 1>(0, 3) = -view.topLeftCorner<3, 3>() * eye;
  const double aspect = (hi.x - lo.x) / std::max(1.0f, hi.y - lo.y);
  camera.clip_from_world = perspective(aspect, o.distance * 0.02, o.distance * 50) * view;
  return camera;
}

std::optional<ImVec2> SceneCamera::project(const Vec3& world) const {
  const Vec4 c = clip_from_world * world.homogeneous();
  if (!(c.w() > 1e-9)) return std::nullopt;
  const auto x = static_cast<float>(c.x() / c.w()), y = static_cast<float>(c.y() / c.w());
  return ImVec2{lo.x + (x + 1) / 2 * (hi.x - lo.x), lo.y + (1 - y) / 2 * (hi.y - lo.y)};
}

void fitScene(SceneOptions& options, const Vec3& center, double radius, double aspect) {
  options.target = center;
  radius /= std::min(1.0, std::max(aspect, 0.2));
  options.distance = std::max(0.05, radius / std::tan(kHalfAngle) * 0.88);
}

void topView(SceneOptions& options) {
  options.yaw = 0;
  options.pitch = 1.5707;
}

}  // namespace svoscope::ui
