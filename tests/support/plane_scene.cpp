// SPDX-License-Identifier: MIT
#include "tests/support/plane_scene.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace svoscope::test {

PlaneScene::PlaneScene(const Pinhole& camera, const Vec3& normal, double distance,
                       double wavelength, unsigned seed)
    : camera_(camera), normal_(normal.normalized()), distance_(distance) {
  axis_u_ = Vec3::UnitY().cross(normal_).normalized();
  axis_v_ = normal_.cross(axis_u_);
  std::mt19937 rng(seed);
  const auto unit = [&rng] { return static_cast<double>(rng()) / 4294967296.0; };
  constexpr int kWaves = 18;
  for (int i = 0; i < kWaves; ++i) {
    // Wavelengths from the shortest to eight times that, evenly in the logarithm.
    const double length = wavelength * std::pow(8.0, static_cast<double>(i) / kWaves);
    const double angle = 2 * M_PI * unit(), k = 2 * M_PI / length;
    waves_.push_back({k * std::cos(angle), k * std::sin(angle), 2 * M_PI * unit(), 12.0});
  }
}

double PlaneScene::grey(const Vec3& p_world) const {
  const double u = axis_u_.dot(p_world), v = axis_v_.dot(p_world);
  double sum = 120;
  for (const Wave& w : waves_) sum += w.amplitude * std::cos(w.u * u + w.v * v + w.phase);
  return sum;
}

Vec3 PlaneScene::point(const SE3& T_cam_world, const Vec2& px) const {
  const SE3 T_world_cam = T_cam_world.inverse();
  const Vec3 ray = T_world_cam.quaternion() * camera_.unproject(px);
  const Vec3& c = T_world_cam.translation();
  return c + ray * ((distance_ - normal_.dot(c)) / normal_.dot(ray));
}

cv::Mat PlaneScene::render(const SE3& T_cam_world, Light light) const {
  cv::Mat image(camera_.height, camera_.width, CV_8UC1);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      const double value = light.gain * grey(point(T_cam_world, {x, y})) + light.offset;
      image.at<std::uint8_t>(y, x) = cv::saturate_cast<std::uint8_t>(value);
    }
  }
  return image;
}

Pinhole smallCamera() {
  Pinhole c;
  c.width = 320;
  c.height = 240;
  c.fx = c.fy = 300;
  c.cx = 159.5;
  c.cy = 119.5;
  return c;
}

std::vector<Vec2> gridPixels(const Pinhole& camera, int step, int border) {
  std::vector<Vec2> pixels;
  for (int y = border; y < camera.height - border; y += step)
    for (int x = border; x < camera.width - border; x += step) pixels.emplace_back(x, y);
  return pixels;
}

double angleDeg(const SE3& a, const SE3& b) {
  return a.quaternion().angularDistance(b.quaternion()) * 180 / M_PI;
}

}  // namespace svoscope::test
