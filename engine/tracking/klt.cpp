// SPDX-License-Identifier: MIT
#include "engine/tracking/klt.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace svoscope {

namespace {

constexpr int kMaxPatch = 32 * 32;
using Floats = Eigen::Map<const Eigen::VectorXf>;

double toLevel(double px, int level) { return (px + 0.5) / (1 << level) - 0.5; }

float bilinear(const cv::Mat& image, double x, double y) {
  const int ix = static_cast<int>(x), iy = static_cast<int>(y);
  const float fx = static_cast<float>(x - ix), fy = static_cast<float>(y - iy);
  const std::uint8_t* a = image.ptr<std::uint8_t>(iy) + ix;
  const std::uint8_t* b = image.ptr<std::uint8_t>(iy + 1) + ix;
  return (1 - fy) * ((1 - fx) * a[0] + fx * a[1]) + fy * ((1 - fx) * b[0] + fx * b[1]);
}

/// Patch of size x size pixels whose first sample lies at (x, y); false if it leaves the image.
bool samplePatch(const cv::Mat& image, double x, double y, int size, float* out) {
  if (!(x >= 0 && y >= 0 && x + size < image.cols && y + size < image.rows)) return false;
  const int ix = static_cast<int>(x), iy = static_cast<int>(y);
  const float fx = static_cast<float>(x - ix), fy = static_cast<float>(y - iy);
  const float w00 = (1 - fx) * (1 - fy), w01 = fx * (1 - fy), w10 = (1 - fx) * fy, w11 = fx * fy;
  for (int r = 0; r < size; ++r) {
    const std::uint8_t* a = image.ptr<std::uint8_t>(iy + r) + ix;
    const std::uint8_t* b = image.ptr<std::uint8_t>(iy + r + 1) + ix;
    for (int c = 0; c < size; ++c)
      out[r * size + c] = w00 * a[c] + w01 * a[c + 1] + w10 * b[c] + w11 * b[c + 1];
  }
  return true;
}

/// In a fixed order. Eigen's mean() adds up what precedes the first aligned address by itself, so
/// that its last digits depend on where the heap put the values, and with them the whole run.
void removeMean(float* v, std::size_t n) {
  constexpr std::size_t kLanes = 8;
  float lanes[kLanes] = {};
  for (std::size_t i = 0; i < n; ++i) lanes[i % kLanes] += v[i];
  float sum = 0;
  for (const float lane : lanes) sum += lane;
  const float mean = sum / static_cast<float>(n);
  for (std::size_t i = 0; i < n; ++i) v[i] -= mean;
}

/// Warped samples with a border of one for the gradients; empty if outside the image.
std::vector<float> warpedSamples(const cv::Mat& image, const Vec2& centre, const Mat2& A_ref_cur,
                                 int half) {
  const int size = 2 * half + 2;
  std::vector<float> samples(static_cast<std::size_t>(size * size));
  for (int r = 0; r < size; ++r)
    for (int c = 0; c < size; ++c) {
      const Vec2 p = centre + A_ref_cur * Vec2(c - half - 0.5, r - half - 0.5);
      if (!(p.x() >= 0 && p.y() >= 0 && p.x() < image.cols - 1 && p.y() < image.rows - 1))
        return {};
      samples[static_cast<std::size_t>(r * size + c)] = bilinear(image, p.x(), p.y());
    }
  return samples;
}

KltTemplate::Level makeLevel(const cv::Mat& image, const Vec2& centre, const Mat2& A_ref_cur,
                             int half) {
  KltTemplate::Level level;
  level.half = half;
  const std::vector<float> s = warpedSamples(image, centre, A_ref_cur, half);
  if (s.empty()) return level;
  const int size = 2 * half, stride = size + 2;
  for (int r = 0; r < size; ++r)
    for (int c = 0; c < size; ++c) {
      const float* p = s.data() + (r + 1) * stride + c + 1;
      level.value.push_back(*p);
      level.gx.push_back(0.5f * (p[1] - p[-1]));
      level.gy.push_back(0.5f * (p[stride] - p[-stride]));
    }
  for (std::vector<float>* v : {&level.value, &level.gx, &level.gy})
    removeMean(v->data(), v->size());
  const Eigen::Index n = static_cast<Eigen::Index>(level.value.size());
  const Floats value(level.value.data(), n), gx(level.gx.data(), n), gy(level.gy.data(), n);
  level.norm = value.norm();
  level.H << gx.squaredNorm(), gx.dot(gy), gx.dot(gy), gy.squaredNorm();
  level.usable = level.norm > 0;
  return level;
}

struct LevelFit {
  bool inside = false, converged = false;
  double correlation = -1;
};

/// Gauss-Newton at one level; `u` is the patch centre in level coordinates.
LevelFit fitLevel(const KltTemplate::Level& level, const cv::Mat& image, const Vec2& prior_u,
                  double prior_information, double stop, int max_iterations, Vec2& u) {
  LevelFit fit;
  const int size = 2 * level.half;
  const Eigen::Index n = static_cast<Eigen::Index>(size) * size;
  alignas(32) float samples[kMaxPatch];
  const Floats value(level.value.data(), n), gx(level.gx.data(), n), gy(level.gy.data(), n);
  const Mat2 H = level.H + (prior_information + 1e-3) * Mat2::Identity();
  const Mat2 H_inverse = H.inverse();
  Eigen::Map<Eigen::VectorXf> s(samples, n);
  for (int k = 0; k <= max_iterations; ++k) {
    fit.inside =
        samplePatch(image, u.x() - level.half + 0.5, u.y() - level.half + 0.5, size, samples);
    if (!fit.inside) return fit;
    if (fit.converged || k == max_iterations) break;
    // The gradients are zero-mean: a brightness offset of the whole patch changes nothing.
    const Vec2 b = Vec2(gx.dot(s - value), gy.dot(s - value)) + prior_information * (u - prior_u);
    const Vec2 step = -(H_inverse * b);
    u += step;
    fit.converged = step.norm() < stop;
  }
  removeMean(samples, static_cast<std::size_t>(n));
  fit.correlation = value.dot(s) / (level.norm * std::max(s.norm(), 1e-6f));
  return fit;
}

}  // namespace

KltTemplate makeKltTemplate(const std::vector<cv::Mat>& pyramid, const Vec2& px_ref,
                            const Mat2& A_cur_ref, const KltParameters& parameters) {
  KltTemplate out;
  out.A_cur_ref = A_cur_ref;
  const Mat2 A_ref_cur = A_cur_ref.inverse();
  for (int l = 0; l < static_cast<int>(pyramid.size()); ++l) {
    const int half = std::min(16, l < 3 ? parameters.half_patch : parameters.half_patch_coarse);
    out.levels.push_back(
        makeLevel(pyramid[l], {toLevel(px_ref.x(), l), toLevel(px_ref.y(), l)}, A_ref_cur, half));
  }
  return out;
}

KltResult trackKlt(const KltTemplate& patch, const std::vector<cv::Mat>& pyramid, const Vec2& guess,
                   const KltPrior& prior, const KltParameters& parameters) {
  KltResult out;
  out.px = guess;
  const int levels = static_cast<int>(std::min(pyramid.size(), patch.levels.size()));
  for (int l = levels - 1; l >= 0; --l) {
    const KltTemplate::Level& level = patch.levels[l];
    if (!level.usable) {
      if (l == 0) return out;
      continue;
    }
    Vec2 u(toLevel(out.px.x(), l), toLevel(out.px.y(), l));
    const Vec2 start = u;
    const Vec2 prior_u(toLevel(prior.px.x(), l), toLevel(prior.px.y(), l));
    const double ratio = parameters.image_noise * (1 << l) / prior.sigma;
    const LevelFit fit = fitLevel(level, pyramid[l], prior_u, ratio * ratio, l > 0 ? 0.05 : 0.01,
                                  parameters.max_iterations, u);
    if (l == 0) {
      out.correlation = fit.correlation;
      out.ok = fit.inside && (u - start).norm() < 2.0 * level.half;
    }
    // A coarse level that runs away or leaves the image is skipped, not believed.
    if (!fit.inside || (l > 0 && (u - start).norm() > 2.0 * level.half)) continue;
    out.px = (u.array() + 0.5) * (1 << l) - 0.5;
  }
  out.ok = out.ok && out.correlation >= parameters.min_correlation;
  return out;
}

}  // namespace svoscope
