// SPDX-License-Identifier: MIT
#include "engine/dataset/synthetic/renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace svoscope::synthetic {
namespace {

const double kNear = 0.02;         ///< m
const int kSubsamples = 4;         ///< per axis, at silhouettes only
const int kMaxProbes = 8;          ///< along the long side of a stretched texture footprint
const float kInsideSlack = 1e-4f;  ///< neighbouring quads overlap a little: no gaps between them

/// a x + b y + c over the pixels of the image.
struct Affine {
  double a, b, c;
  double operator()(double x, double y) const { return a * x + b * y + c; }
};

/// A quad as seen by the camera. The ray (X, Y, 1) at depth z hits it at u, v where
/// (u, v, 1) / z = inverse([edge_u edge_v corner]) (X, Y, 1): all three are affine in the pixel.
struct SeenQuad {
  Affine u_over_z, v_over_z, inv_z;
  std::array<Vec3, 4> corners;  ///< camera frame, in order around the quad
  const Texture* texture;
  float gain;
};

class Painter {
 public:
  Painter(const Scene& scene, const Pinhole& camera, const SE3& T_world_cam,
          const std::vector<Quad>& extra);

  cv::Mat depth() const;
  cv::Mat shade() const;

 private:
  void see(const Quad& quad, const SE3& T_cam_quad);
  void fill(const SeenQuad& quad, int id);
  bool silhouette(int x, int y) const;
  float shadePixel(int x, int y, const SeenQuad& quad) const;
  float shadeSilhouette(int x, int y) const;
  float background(double x, double y) const;

  const Scene& scene_;
  const Pinhole& camera_;
  Vec3 up_cam_;  ///< direction to the zenith, camera frame
  std::vector<SeenQuad> quads_;
  cv::Mat inv_z_;  ///< CV_32F, 0 where nothing is hit
  cv::Mat ids_;    ///< CV_32S, index into quads_, -1 where nothing is hit
};

Painter::Painter(const Scene& scene, const Pinhole& camera, const SE3& T_world_cam,
                 const std::vector<Quad>& extra)
    : scene_(scene),
      camera_(camera),
      up_cam_(T_world_cam.quaternion().conjugate() * Vec3::UnitZ()),
      inv_z_(camera.height, camera.width, CV_32FC1, cv::Scalar(0)),
      ids_(camera.height, camera.width, CV_32SC1, cv::Scalar(-1)) {
  const SE3 T_cam_world = T_world_cam.inverse();
  for (const Quad& quad : scene.quads) see(quad, T_cam_world);
  for (const Quad& quad : extra) see(quad, SE3());
  for (size_t i = 0; i < quads_.size(); ++i) fill(quads_[i], static_cast<int>(i));
}

void Painter::see(const Quad& quad, const SE3& T_cam_quad) {
  const Vec3 p = T_cam_quad * quad.corner;
  const Vec3 eu = T_cam_quad.quaternion() * quad.edge_u, ev = T_cam_quad.quaternion() * quad.edge_v;
  SeenQuad seen;
  seen.corners = {p, p + eu, p + eu + ev, p + ev};
  if (std::all_of(seen.corners.begin(), seen.corners.end(),
                  [](const Vec3& c) { return c.z() < kNear; }))
    return;
  Mat3 M;
  M << eu, ev, p;
  // Seen edge-on: the camera is in the plane of the quad.
  if (std::abs(M.determinant()) < 1e-9 * eu.norm() * ev.norm()) return;
  const Mat3 N = M.inverse();
  const auto affine = [&](int row, double scale) {
    return Affine{scale * N(row, 0) / camera_.fx, scale * N(row, 1) / camera_.fy,
                  scale * (N(row, 2) - N(row, 0) * camera_.cx / camera_.fx -
                           N(row, 1) * camera_.cy / camera_.fy)};
  };
  seen.u_over_z = affine(0, 1);
  seen.v_over_z = affine(1, 1);
  seen.inv_z = affine(2, 1);
  seen.texture = &scene_.textures[quad.texture];
  seen.gain = quad.gain;
  quads_.push_back(seen);
}

/// Corners of the part in front of the camera, in pixels.
std::vector<Vec2> projectClipped(const SeenQuad& quad, const Pinhole& camera) {
  std::vector<Vec2> polygon;
  for (int i = 0; i < 4; ++i) {
    const Vec3 &a = quad.corners[i], &b = quad.corners[(i + 1) % 4];
    if (a.z() >= kNear) polygon.push_back(camera.project(a));
    if ((a.z() >= kNear) != (b.z() >= kNear))
      polygon.push_back(camera.project(a + (b - a) * ((kNear - a.z()) / (b.z() - a.z()))));
  }
  return polygon;
}

/// Visits the pixels of the quad row by row and keeps the nearest surface.
void Painter::fill(const SeenQuad& quad, int id) {
  const std::vector<Vec2> polygon = projectClipped(quad, camera_);
  if (polygon.size() < 3) return;
  double top = polygon[0].y(), bottom = top;
  for (const Vec2& p : polygon) {
    top = std::min(top, p.y());
    bottom = std::max(bottom, p.y());
  }
  const int y0 = static_cast<int>(std::ceil(std::max(0.0, top)));
  const int y1 = static_cast<int>(std::floor(std::min(camera_.height - 1.0, bottom)));
  for (int y = y0; y <= y1; ++y) {
    double left = 1e9, right = -1e9;
    for (size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      if ((a.y() < y && b.y() < y) || (a.y() > y && b.y() > y)) continue;
      const double dy = b.y() - a.y();
      const double s = std::abs(dy) < 1e-12 ? 0.0 : std::clamp((y - a.y()) / dy, 0.0, 1.0);
      for (double x :
           {a.x() + s * (b.x() - a.x()), dy == 0 ? b.x() : a.x() + s * (b.x() - a.x())}) {
        left = std::min(left, x);
        right = std::max(right, x);
      }
    }
    const int x0 = static_cast<int>(std::ceil(std::max(0.0, left - 1e-6)));
    const int x1 = static_cast<int>(std::floor(std::min(camera_.width - 1.0, right + 1e-6)));
    float* inv_z = inv_z_.ptr<float>(y);
    int* ids = ids_.ptr<int>(y);
    const double start = quad.inv_z(0, y), step = quad.inv_z.a;
    for (int x = x0; x <= x1; ++x) {
      const float w = static_cast<float>(start + step * x);
      const bool nearer = w > inv_z[x];
      inv_z[x] = nearer ? w : inv_z[x];
      ids[x] = nearer ? id : ids[x];
    }
  }
}

cv::Mat Painter::depth() const {
  cv::Mat depth(inv_z_.size(), CV_32FC1);
  for (int y = 0; y < depth.rows; ++y) {
    const float* w = inv_z_.ptr<float>(y);
    float* z = depth.ptr<float>(y);
    for (int x = 0; x < depth.cols; ++x) z[x] = w[x] > 0 ? 1.f / w[x] : 0.f;
  }
  return depth;
}

float Painter::background(double x, double y) const {
  const Vec3 ray = camera_.bearing({x, y});
  return scene_.sky * static_cast<float>(1.0 - 0.25 * std::max(0.0, ray.dot(up_cam_)));
}

/// log2 to within 0.09, continuous: plenty for choosing a mip level.
float roughLog2(float v) {
  std::int32_t bits;
  std::memcpy(&bits, &v, sizeof bits);
  return static_cast<float>(bits) * (1.f / 8388608.f) - 127.f;
}

/// Place in the texture and its change from pixel to pixel, texels.
struct Footprint {
  float x, y;            ///< texel coordinates
  float xx, xy, yx, yy;  ///< d (x, y) / d pixel x, d (x, y) / d pixel y
};

Footprint footprint(const SeenQuad& q, double x, double y) {
  const double w = q.inv_z(x, y), z = 1.0 / w;
  const double u = q.u_over_z(x, y) * z, v = q.v_over_z(x, y) * z;
  const double su = z * q.texture->width(), sv = z * q.texture->height();
  Footprint f;
  f.x = static_cast<float>(u * q.texture->width() - 0.5);
  f.y = static_cast<float>(v * q.texture->height() - 0.5);
  f.xx = static_cast<float>((q.u_over_z.a - u * q.inv_z.a) * su);
  f.xy = static_cast<float>((q.v_over_z.a - v * q.inv_z.a) * sv);
  f.yx = static_cast<float>((q.u_over_z.b - u * q.inv_z.b) * su);
  f.yy = static_cast<float>((q.v_over_z.b - v * q.inv_z.b) * sv);
  return f;
}

/// Averages several probes along the long side of the footprint: surfaces seen at a grazing angle
/// are neither aliased nor blurred.
float Painter::shadePixel(int x, int y, const SeenQuad& quad) const {
  const Footprint f = footprint(quad, x, y);
  const float len_x = f.xx * f.xx + f.xy * f.xy, len_y = f.yx * f.yx + f.yy * f.yy;
  const float major = std::max(len_x, len_y), minor = std::min(len_x, len_y);
  int probes = 1;
  if (major > 1.f && major > 2.25f * minor)
    probes = std::min(kMaxProbes, static_cast<int>(std::sqrt(major / std::max(minor, 1.f)) + 0.5f));
  const float inverse = 1.f / static_cast<float>(probes);
  const float lod = 0.5f * roughLog2(major * inverse * inverse);
  if (probes <= 1) return quad.gain * quad.texture->sample(f.x, f.y, lod);
  const float dx = len_x > len_y ? f.xx : f.yx, dy = len_x > len_y ? f.xy : f.yy;
  float sum = 0;
  for (int i = 0; i < probes; ++i) {
    const float s = (static_cast<float>(i) + 0.5f) * inverse - 0.5f;
    sum += quad.texture->sample(f.x + s * dx, f.y + s * dy, lod);
  }
  return quad.gain * sum * inverse;
}

bool Painter::silhouette(int x, int y) const {
  const int id = ids_.at<int>(y, x);
  return (x > 0 && ids_.at<int>(y, x - 1) != id) ||
         (x + 1 < ids_.cols && ids_.at<int>(y, x + 1) != id) ||
         (y > 0 && ids_.at<int>(y - 1, x) != id) ||
         (y + 1 < ids_.rows && ids_.at<int>(y + 1, x) != id);
}

/// Where surfaces meet, the pixel is the mean over a grid of rays; they can only hit what the
/// pixel and its neighbours show.
float Painter::shadeSilhouette(int x, int y) const {
  std::array<int, 9> candidates;
  int count = 0;
  for (int j = std::max(0, y - 1); j <= std::min(ids_.rows - 1, y + 1); ++j) {
    for (int i = std::max(0, x - 1); i <= std::min(ids_.cols - 1, x + 1); ++i) {
      const int id = ids_.at<int>(j, i);
      const auto end = candidates.begin() + count;
      if (id >= 0 && std::find(candidates.begin(), end, id) == end) candidates[count++] = id;
    }
  }
  float sum = 0;
  for (int k = 0; k < kSubsamples * kSubsamples; ++k) {
    const double sx = x + (k % kSubsamples + 0.5) / kSubsamples - 0.5;
    const double sy = y + (k / kSubsamples + 0.5) / kSubsamples - 0.5;
    double nearest = 0;
    const SeenQuad* hit = nullptr;
    for (int c = 0; c < count; ++c) {
      const SeenQuad& q = quads_[candidates[c]];
      const double w = q.inv_z(sx, sy);
      if (w <= nearest) continue;
      const double u = q.u_over_z(sx, sy) / w, v = q.v_over_z(sx, sy) / w;
      if (std::min(u, v) < -kInsideSlack || std::max(u, v) > 1 + kInsideSlack) continue;
      nearest = w;
      hit = &q;
    }
    if (!hit) {
      sum += background(sx, sy);
      continue;
    }
    const Footprint f = footprint(*hit, sx, sy);
    const float spread = std::max(f.xx * f.xx + f.xy * f.xy, f.yx * f.yx + f.yy * f.yy);
    const float lod = 0.5f * roughLog2(spread) - 1.f;  // the grid covers the rest of the pixel
    sum += hit->gain * hit->texture->sample(f.x, f.y, lod);
  }
  return sum / (kSubsamples * kSubsamples);
}

cv::Mat Painter::shade() const {
  cv::Mat gray(ids_.size(), CV_32FC1);
  for (int y = 0; y < gray.rows; ++y) {
    const int* ids = ids_.ptr<int>(y);
    float* out = gray.ptr<float>(y);
    for (int x = 0; x < gray.cols; ++x) {
      if (silhouette(x, y))
        out[x] = shadeSilhouette(x, y);
      else if (ids[x] >= 0)
        out[x] = shadePixel(x, y, quads_[ids[x]]);
      else
        out[x] = background(x, y);
    }
  }
  return gray;
}

}  // namespace

View render(const Scene& scene, const Pinhole& camera, const SE3& T_world_cam,
            const std::vector<Quad>& extra) {
  const Painter painter(scene, camera, T_world_cam, extra);
  return {painter.shade(), painter.depth()};
}

cv::Mat renderDepth(const Scene& scene, const Pinhole& camera, const SE3& T_world_cam,
                    const std::vector<Quad>& extra) {
  return Painter(scene, camera, T_world_cam, extra).depth();
}

}  // namespace svoscope::synthetic
