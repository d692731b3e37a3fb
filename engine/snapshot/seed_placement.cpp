// SPDX-License-Identifier: MIT
#include "engine/snapshot/seed_placement.h"

#include <algorithm>

namespace svoscope {

void placeSeed(SeedView& v, const SeedPlacement& p) {
  if (!p.wanted) return;
  constexpr double kFarthest = 1e-6, kNearest = 1e-3;  // inverse distance; z before the camera
  const double mu = v.mu, sigma = v.sigma, n = p.search_sigmas;
  const double z[3] = {mu, mu + n * sigma, std::max(mu - n * sigma, 0.05 * mu)};
  const Vec3 f = p.camera.bearing(v.px_ref.cast<double>());
  Vec3f* world[3] = {&v.position, &v.position_near, &v.position_far};
  Vec2f* px[3] = {&v.px, &v.px_near, &v.px_far};
  bool front = true;
  for (int i = 0; i < 3; ++i) {
    const Vec3 p_world = p.T_world_kf * (f / std::max(z[i], kFarthest));
    *world[i] = p_world.cast<float>();
    const Vec3 p_cam = p.T_cam_world * p_world;
    front = front && p_cam.z() > kNearest;
    *px[i] = front ? Vec2f(p.camera.project(p_cam).cast<float>()) : v.px;
  }
  v.visible = front && p.camera.inside(v.px.cast<double>(), 0);
  if (v.type != FeatureType::segment) return;
  const Vec3 f_end = p.camera.bearing(v.px_ref_end.cast<double>());
  v.position_end = (p.T_world_kf * (f_end / std::max<double>(v.mu_end, kFarthest))).cast<float>();
}

}  // namespace svoscope
