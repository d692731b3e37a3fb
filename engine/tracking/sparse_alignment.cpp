// SPDX-License-Identifier: MIT
#include "engine/tracking/sparse_alignment.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/match/patch.h"

namespace svoscope {

namespace {

constexpr int kSide = 4, kHalf = 2, kArea = kSide * kSide;
constexpr int kParameters = 8;  // twist (6), gain, offset
constexpr int kLeastPatches = 8;

using Mat8 = Eigen::Matrix<double, 8, 8>;
using Vec8 = Eigen::Matrix<double, 8, 1>;

/// One reference patch on one level.
struct LevelPatch {
  Vec3 p_ref;
  alignas(32) float value[kArea];
  alignas(32) float jacobian[kParameters][kArea];
  float hessian[kParameters][kParameters];
};

struct Window {
  int x, y;
  float w00, w01, w10, w11;
};

/// Window of the patch around level pixel (x, y); false if it leaves the image (with `border`).
bool makeWindow(const cv::Mat& image, const Vec2& px, int border, Window& w) {
  const double x = px.x() - kHalf, y = px.y() - kHalf;
  if (!(x >= border && y >= border && x < image.cols - kSide - 1 - border &&
        y < image.rows - kSide - 1 - border))
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
  for (int i = 0; i < kSide; ++i) {
    const std::uint8_t* p = image.ptr<std::uint8_t>(w.y + i) + w.x;
    const std::uint8_t* q = p + image.step[0];
    for (int j = 0; j < kSide; ++j) {
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
  for (int i = 0, n = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j, ++n) {
      const float dx = 0.5f * (sampleAt(image, w, i, j + 1) - sampleAt(image, w, i, j - 1));
      const float dy = 0.5f * (sampleAt(image, w, i + 1, j) - sampleAt(image, w, i - 1, j));
      for (int k = 0; k < 6; ++k)
        patch.jacobian[k][n] = dx * static_cast<float>(J(0, k)) + dy * static_cast<float>(J(1, k));
      patch.jacobian[6][n] = patch.value[n];
      patch.jacobian[7][n] = 1;
    }
  }
  for (int a = 0; a < kParameters; ++a) {
    for (int b = a; b < kParameters; ++b) {
      float sum = 0;
      for (int n = 0; n < kArea; ++n) sum += patch.jacobian[a][n] * patch.jacobian[b][n];
      patch.hessian[a][b] = patch.hessian[b][a] = sum;
    }
  }
  return true;
}

struct State {
  SE3 T_cur_ref;
  double gain = 1, offset = 0;
};

struct Normal {
  Mat8 H = Mat8::Zero();
  Vec8 b = Vec8::Zero();
  double error = 0, weight = 0;  ///< weighted squared error and weight, per pixel
  int visible = 0;
};

/// Robust scale of the patches' RMS errors, fixed per level.
double median(std::vector<float>& values) {
  if (values.empty()) return 1;
  auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

class LevelAligner {
 public:
  LevelAligner(const Pyramid& ref, const Pyramid& cur, const Pinhole& camera, int level)
      : image_ref_(ref[level]), image_cur_(cur[level]), camera_(camera), level_(level) {}

  void addPatches(const std::vector<AlignmentPatch>& sources) {
    patches_.reserve(sources.size());
    LevelPatch patch;
    for (const AlignmentPatch& s : sources) {
      if (makePatch(image_ref_, camera_, s, level_, patch)) patches_.push_back(patch);
    }
  }
  std::size_t size() const { return patches_.size(); }

  /// Sets the robust scale from the errors at `state`.
  void setScale(const State& state) {
    std::vector<float> rms;
    visit(state, [&](const LevelPatch&, const float*, float squared) {
      rms.push_back(std::sqrt(squared / kArea));
    });
    scale_ = std::max(1.5, 1.5 * median(rms));
  }

  Normal linearize(const State& state) const {
    Normal n;
    float H[kParameters][kParameters] = {};
    float b[kParameters] = {};
    visit(state, [&](const LevelPatch& p, const float* r, float squared) {
      // Cauchy weight per patch: an occluded patch loses all its pixels at once.
      const float w = 1.0f / (1.0f + squared / (kArea * static_cast<float>(scale_ * scale_)));
      for (int a = 0; a < kParameters; ++a) {
        float sum = 0;
        for (int k = 0; k < kArea; ++k) sum += p.jacobian[a][k] * r[k];
        b[a] += w * sum;
        for (int c = 0; c < kParameters; ++c) H[a][c] += w * p.hessian[a][c];
      }
      n.error += w * squared;
      n.weight += w * kArea;
      ++n.visible;
    });
    for (int a = 0; a < kParameters; ++a) {
      n.b[a] = b[a];
      for (int c = 0; c < kParameters; ++c) n.H(a, c) = H[a][c];
    }
    return n;
  }

  /// Image motion of a twist, px of this level, for a typical point.
  double motionPx(const Vec8& step) const {
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < patches_.size(); i += 1 + patches_.size() / 16, ++count) {
      sum += (pixelTwistJacobian(camera_, patches_[i].p_ref) * step.head<6>()).norm();
    }
    return sum / std::max(count, 1) / (1 << level_);
  }

 private:
  template <typename Visit>
  void visit(const State& state, const Visit& f) const {
    const Mat3 R = state.T_cur_ref.rotation();
    const Vec3 t = state.T_cur_ref.translation();
    const auto inverse_gain = static_cast<float>(1.0 / state.gain);
    const auto offset = static_cast<float>(state.offset);
    alignas(32) float r[kArea];
    for (const LevelPatch& p : patches_) {
      const Vec3 q = R * p.p_ref + t;
      if (q.z() < 1e-3) continue;
      Window w;
      if (!makeWindow(image_cur_, toLevel(camera_.project(q), level_), 0, w)) continue;
      sampleWindow(image_cur_, w, r);
      float squared = 0;
      for (int k = 0; k < kArea; ++k) {
        r[k] = (r[k] - offset) * inverse_gain - p.value[k];
        squared += r[k] * r[k];
      }
      f(p, r, squared);
    }
  }

  const cv::Mat& image_ref_;
  const cv::Mat& image_cur_;
  const Pinhole& camera_;
  int level_;
  double scale_ = 10;
  std::vector<LevelPatch> patches_;
};

Vec8 solve(Normal n, bool estimate_gain) {
  // Weak priors keep gain and offset near one and zero on textureless input.
  n.H(6, 6) += 1e3;
  n.H(7, 7) += 1.0;
  if (!estimate_gain) {
    n.H.row(6).setZero();
    n.H.col(6).setZero();
    n.H.row(7).setZero();
    n.H.col(7).setZero();
    n.H(6, 6) = n.H(7, 7) = 1;
    n.b[6] = n.b[7] = 0;
  }
  return n.H.ldlt().solve(n.b);
}

State applied(const State& s, const Vec8& step) {
  State next;
  next.T_cur_ref = s.T_cur_ref * SE3::exp(-step.head<6>());
  next.gain = std::clamp(s.gain * (1 + std::clamp(step[6], -0.5, 0.5)), 0.2, 5.0);
  next.offset = s.offset + s.gain * step[7];
  return next;
}

/// Gauss-Newton on one level; a step that raises the error is undone and ends the level.
Normal alignLevel(LevelAligner& level, const SparseAlignmentParameters& p, State& state, int& iterations) {
  level.setScale(state);
  Normal n = level.linearize(state);
  for (int it = 0; it < p.max_iterations && n.visible >= kLeastPatches; ++it) {
    const Vec8 step = solve(n, p.estimate_gain);
    if (!step.allFinite()) break;
    const State next = applied(state, step);
    const Normal m = level.linearize(next);
    ++iterations;
    const bool worse = m.visible < kLeastPatches || m.error / m.weight > n.error / n.weight * 1.0001;
    if (worse && it > 0) break;
    state = next;
    n = m;
    if (level.motionPx(step) < p.min_step_px) break;
  }
  return n;
}

std::vector<AlignmentPatch> thinned(const std::vector<AlignmentPatch>& patches, int most) {
  const std::size_t limit = static_cast<std::size_t>(std::max(most, 1));
  if (patches.size() <= limit) return patches;
  std::vector<AlignmentPatch> kept;
  for (std::size_t i = 0; i < limit; ++i) kept.push_back(patches[i * patches.size() / limit]);
  return kept;
}

}  // namespace

Mat26 pixelTwistJacobian(const Pinhole& camera, const Vec3& p) {
  Eigen::Matrix<double, 3, 6> dp;
  dp << Mat3::Identity(), -hat(p);
  return camera.projectJacobian(p) * dp;
}

double photometricError(const Pyramid& ref, const Pyramid& cur, const Pinhole& camera,
                        const std::vector<AlignmentPatch>& patches, const SE3& T_cur_ref, int level) {
  LevelAligner aligner(ref, cur, camera, std::min<int>(level, static_cast<int>(ref.size()) - 1));
  aligner.addPatches(patches);
  State state;
  state.T_cur_ref = T_cur_ref;
  aligner.setScale(state);
  Normal n = aligner.linearize(state);
  if (n.visible * 3 < static_cast<int>(patches.size()) || n.visible < kLeastPatches)
    return std::numeric_limits<double>::infinity();
  // Brightness alone, the motion held.
  const Mat2 H = n.H.bottomRightCorner<2, 2>() + Vec2(1e3, 1.0).asDiagonal().toDenseMatrix();
  const Vec2 brightness = H.ldlt().solve(n.b.tail<2>());
  state.gain = std::clamp(1 + brightness[0], 0.2, 5.0);
  state.offset = brightness[1];
  aligner.setScale(state);
  n = aligner.linearize(state);
  // The Cauchy cost itself would saturate; the plain mean over visible patches compares better.
  return n.error / n.weight;
}

SparseAlignmentResult alignSparse(const Pyramid& ref, const Pyramid& cur, const Pinhole& camera,
                                  const std::vector<AlignmentPatch>& all, const SE3& T_init,
                                  const SparseAlignmentParameters& p) {
  SparseAlignmentResult result;
  result.T_cur_ref = T_init;
  const std::vector<AlignmentPatch> patches = thinned(all, p.max_patches);
  State state;
  state.T_cur_ref = T_init;
  const int top = std::min({p.max_level, static_cast<int>(ref.size()) - 1, static_cast<int>(cur.size()) - 1});
  for (int level = top; level >= std::min(p.min_level, top); --level) {
    LevelAligner aligner(ref, cur, camera, level);
    aligner.addPatches(patches);
    if (static_cast<int>(aligner.size()) < kLeastPatches) continue;
    const Normal n = alignLevel(aligner, p, state, result.iterations);
    result.patches = n.visible;
    result.rmse = n.weight > 0 ? std::sqrt(n.error / n.weight) : 0;
  }
  result.ok = result.patches >= kLeastPatches && state.T_cur_ref.finite();
  if (!result.ok) return result;
  result.T_cur_ref = state.T_cur_ref;
  result.gain = state.gain;
  result.offset = state.offset;
  return result;
}

}  // namespace svoscope
