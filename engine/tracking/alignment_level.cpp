// SPDX-License-Identifier: MIT
#include "engine/tracking/alignment_level.h"

#include <algorithm>
#include <cmath>

#include "engine/match/patch.h"

namespace svoscope {

namespace {

constexpr int kHalf = kAlignmentSide / 2;

struct Window {
  int x, y;
  float w00, w01, w10, w11;
};

/// Window of the patch around level pixel (x, y); false if it leaves the image (with `border`).
bool makeWindow(const cv::Mat& image, const Vec2& px, int border, Window& w) {
  const double x = px.x() - kHalf, y = px.y() - kHalf;
  if (!(x >= border && y >= border && x < image.cols - kAlignmentSide - 1 - border &&
        y < image.rows - kAlignmentSide - 1 - border))
    return false;
  w.x = static_cast<int>(x);
  w.y = static_cast<int>(y);
  const auto sx = static_cast<float>(x - w.x), sy = static_cast<float>(y - w.y);
  w.w00 = (1 - sx) * (1 - sy);
  w.w01 = sx * (1 - sy);
  w.w10 = (1 - sx) * sy;
  w.w11 = sx * sy;
  return true;
}

inline float sampleAt(const cv::Mat& image, const Window& w, int i, int j) {
  const std::uint8_t* p = image.ptr<std::uint8_t>(w.y + i) + w.x + j;
  const std::uint8_t* q = p + image.step[0];
  return w.w00 * p[0] + w.w01 * p[1] + w.w10 * q[0] + w.w11 * q[1];
}

void sampleWindow(const cv::Mat& image, const Window& w, float* out) {
  for (int i = 0; i < kAlignmentSide; ++i) {
    const std::uint8_t* p = image.ptr<std::uint8_t>(w.y + i) + w.x;
    const std::uint8_t* q = p + image.step[0];
    for (int j = 0; j < kAlignmentSide; ++j) {
      *out++ = w.w00 * p[j] + w.w01 * p[j + 1] + w.w10 * q[j] + w.w11 * q[j + 1];
    }
  }
}

bool makePatch(const cv::Mat& image, const Pinhole& camera, const AlignmentPatch& source, int level,
               LevelPatch& patch) {
  Window w;
  if (!makeWindow(image, toLevel(source.px_ref, level), 1, w)) return false;
  patch.p_ref = source.p_ref;
  sampleWindow(image, w, patch.value);
  const Mat26 J = pixelTwistJacobian(camera, source.p_ref) / (1 << level);
  for (int i = 0, n = 0; i < kAlignmentSide; ++i) {
    for (int j = 0; j < kAlignmentSide; ++j, ++n) {
      const float dx = 0.5f * (sampleAt(image, w, i, j + 1) - sampleAt(image, w, i, j - 1));
      const float dy = 0.5f * (sampleAt(image, w, i + 1, j) - sampleAt(image, w, i - 1, j));
      for (int k = 0; k < 6; ++k)
        patch.jacobian[k][n] = dx * static_cast<float>(J(0, k)) + dy * static_cast<float>(J(1, k));
      patch.jacobian[6][n] = patch.value[n];
      patch.jacobian[7][n] = 1;
    }
  }
  for (int a = 0; a < kAlignmentParameters; ++a) {
    for (int b = a; b < kAlignmentParameters; ++b) {
      float sum = 0;
      for (int n = 0; n < kAlignmentArea; ++n) sum += patch.jacobian[a][n] * patch.jacobian[b][n];
      patch.hessian[a][b] = patch.hessian[b][a] = sum;
    }
  }
  return true;
}

/// Robust scale of the patches' RMS errors, fixed per level.
double median(std::vector<float>& values) {
  if (values.empty()) return 1;
  auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

void LevelAligner::addPatches(const std::vector<AlignmentPatch>& sources) {
  patches_.reserve(sources.size());
  LevelPatch patch;
  for (const AlignmentPatch& s : sources) {
    if (makePatch(image_ref_, camera_, s, level_, patch)) patches_.push_back(patch);
  }
}

template <typename Visit>
void LevelAligner::visit(const AlignmentState& state, const Visit& f) const {
  const Mat3 R = state.T_cur_ref.rotation();
  const Vec3 t = state.T_cur_ref.translation();
  const auto inverse_gain = static_cast<float>(1.0 / state.gain);
  const auto offset = static_cast<float>(state.offset);
  alignas(32) float r[kAlignmentArea];
  for (const LevelPatch& p : patches_) {
    const Vec3 q = R * p.p_ref + t;
    if (q.z() < 1e-3) continue;
    Window w;
    if (!makeWindow(image_cur_, toLevel(camera_.project(q), level_), 0, w)) continue;
    sampleWindow(image_cur_, w, r);
    float squared = 0;
    for (int k = 0; k < kAlignmentArea; ++k) {
      r[k] = (r[k] - offset) * inverse_gain - p.value[k];
      squared += r[k] * r[k];
    }
    f(p, r, squared);
  }
}

void LevelAligner::setScale(const AlignmentState& state) {
  std::vector<float> rms;
  visit(state, [&](const LevelPatch&, const float*, float squared) {
    rms.push_back(std::sqrt(squared / kAlignmentArea));
  });
  scale_ = std::max(1.5, 1.5 * median(rms));
}

AlignmentNormal LevelAligner::linearize(const AlignmentState& state) const {
  AlignmentNormal n;
  float H[kAlignmentParameters][kAlignmentParameters] = {};
  float b[kAlignmentParameters] = {};
  visit(state, [&](const LevelPatch& p, const float* r, float squared) {
    // Cauchy weight per patch: an occluded patch loses all its pixels at once.
    const float w =
        1.0f / (1.0f + squared / (kAlignmentArea * static_cast<float>(scale_ * scale_)));
    for (int a = 0; a < kAlignmentParameters; ++a) {
      float sum = 0;
      for (int k = 0; k < kAlignmentArea; ++k) sum += p.jacobian[a][k] * r[k];
      b[a] += w * sum;
      for (int c = 0; c < kAlignmentParameters; ++c) H[a][c] += w * p.hessian[a][c];
    }
    n.error += w * squared;
    n.weight += w * kAlignmentArea;
    ++n.visible;
  });
  for (int a = 0; a < kAlignmentParameters; ++a) {
    n.b[a] = b[a];
    for (int c = 0; c < kAlignmentParameters; ++c) n.H(a, c) = H[a][c];
  }
  return n;
}

double LevelAligner::motionPx(const Vec8& step) const {
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < patches_.size(); i += 1 + patches_.size() / 16, ++count) {
    sum += (pixelTwistJacobian(camera_, patches_[i].p_ref) * step.head<6>()).norm();
  }
  return sum / std::max(count, 1) / (1 << level_);
}

}  // namespace svoscope
