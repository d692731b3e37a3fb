// SPDX-License-Identifier: MIT
#include "engine/frame/rectifier.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace svoscope {
namespace {

const double kMinFocalRatio = 0.5;  ///< new focal length / old, at least

bool distorts(const Camera& camera) {
  const auto zero = [](double c) { return c == 0.0; };
  if (camera.distortion == Distortion::none) return false;
  // Calibration files often state radtan with zeros for images that are rectified already.
  return camera.distortion != Distortion::radtan ||
         !std::all_of(camera.coefficients.begin(), camera.coefficients.end(), zero);
}

/// Rectangle on the plane z = 1.
struct Window {
  double left, right, top, bottom;
};

/// The largest window that the rays of all four image borders leave free. Border pixels without
/// a ray (beyond 90 degrees) set no limit; the caller's start window does.
Window innerWindow(const Camera& camera, Window w) {
  const double x1 = camera.pinhole.width - 1, y1 = camera.pinhole.height - 1;
  const auto ray = [&](double x, double y) { return camera.unproject({x, y}); };
  for (int i = 0; i <= y1; ++i) {
    const Vec3 l = ray(0, i), r = ray(x1, i);
    if (l.allFinite()) w.left = std::max(w.left, l.x());
    if (r.allFinite()) w.right = std::min(w.right, r.x());
  }
  for (int i = 0; i <= x1; ++i) {
    const Vec3 t = ray(i, 0), b = ray(i, y1);
    if (t.allFinite()) w.top = std::max(w.top, t.y());
    if (b.allFinite()) w.bottom = std::min(w.bottom, b.y());
  }
  return w;
}

/// True if the border of the rectified image maps into the original, and a little further out
/// still back to the same ray: where a lens model folds back, the image is a smear.
bool fits(const Camera& camera, const Pinhole& p) {
  const auto inside = [&](double x, double y) {
    const Vec3 ray = p.unproject({x, y});
    const Vec2 px = camera.project(ray);
    const bool in = px.x() >= 0 && px.y() >= 0 && px.x() <= camera.pinhole.width - 1 &&
                    px.y() <= camera.pinhole.height - 1;
    const Vec3 beyond(1.05 * ray.x(), 1.05 * ray.y(), 1.0);
    return in && (camera.unproject(camera.project(beyond)) - beyond).norm() < 1e-6;
  };
  for (int x = 0; x < p.width; ++x)
    if (!inside(x, 0) || !inside(x, p.height - 1)) return false;
  for (int y = 0; y < p.height; ++y)
    if (!inside(0, y) || !inside(p.width - 1, y)) return false;
  return true;
}

}  // namespace

Pinhole rectifiedPinhole(const Camera& camera) {
  if (!distorts(camera)) return camera.pinhole;
  const Pinhole& old = camera.pinhole;
  const double half_x = 0.5 * (old.width - 1) / (kMinFocalRatio * old.fx);
  const double half_y = 0.5 * (old.height - 1) / (kMinFocalRatio * old.fy);
  const Window w = innerWindow(camera, {-half_x, half_x, -half_y, half_y});
  const double mid_x = 0.5 * (w.left + w.right), mid_y = 0.5 * (w.top + w.bottom);
  // One factor for both axes keeps pixels as square as they were.
  double factor = std::max({kMinFocalRatio, (old.width - 1) / ((w.right - w.left) * old.fx),
                            (old.height - 1) / ((w.bottom - w.top) * old.fy)});
  Pinhole p = old;
  // The window is free of the border rays; rounding and odd lens shapes may ask for a little more.
  for (int i = 0; i < 400; ++i, factor *= 1.005) {
    p.fx = factor * old.fx;
    p.fy = factor * old.fy;
    p.cx = 0.5 * (old.width - 1) - p.fx * mid_x;
    p.cy = 0.5 * (old.height - 1) - p.fy * mid_y;
    if (fits(camera, p)) break;
  }
  return p;
}

Rectifier::Rectifier(const Camera& camera)
    : pinhole_(rectifiedPinhole(camera)), identity_(!distorts(camera)) {
  if (!identity_) buildMaps(camera);
}

void Rectifier::buildMaps(const Camera& camera) {
  cv::Mat map(pinhole_.height, pinhole_.width, CV_32FC2);
  for (int y = 0; y < map.rows; ++y) {
    auto* row = map.ptr<cv::Vec2f>(y);
    for (int x = 0; x < map.cols; ++x) {
      const Vec2 px = camera.project(pinhole_.unproject(Vec2(x, y)));
      row[x] = {static_cast<float>(px.x()), static_cast<float>(px.y())};
    }
  }
  cv::convertMaps(map, cv::noArray(), map_xy_, map_fraction_, CV_16SC2);
}

cv::Mat Rectifier::rectify(const cv::Mat& gray) const {
  if (identity_ || gray.empty()) return gray;
  cv::Mat out;
  cv::remap(gray, out, map_xy_, map_fraction_, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  return out;
}

cv::Mat Rectifier::rectifyDepth(const cv::Mat& depth) const {
  if (identity_ || depth.empty()) return depth;
  cv::Mat out;
  cv::remap(depth, out, map_xy_, map_fraction_, cv::INTER_NEAREST, cv::BORDER_REPLICATE);
  return out;
}

}  // namespace svoscope
