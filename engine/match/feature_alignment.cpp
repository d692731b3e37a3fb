// SPDX-License-Identifier: MIT
#include "engine/match/feature_alignment.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace svoscope {

namespace {

/// Samples the 8x8 patch whose pixel (4, 4) lies at (x, y).
inline void samplePatch(const cv::Mat& image, float x, float y, float* out) {
  const int xi = static_cast<int>(std::floor(x)), yi = static_cast<int>(std::floor(y));
  const float sx = x - static_cast<float>(xi), sy = y - static_cast<float>(yi);
  const float w00 = (1 - sx) * (1 - sy), w01 = sx * (1 - sy), w10 = (1 - sx) * sy, w11 = sx * sy;
  for (int i = 0; i < kPatchSize; ++i) {
    const std::uint8_t* __restrict p =
        image.ptr<std::uint8_t>(yi - kPatchHalf + i) + xi - kPatchHalf;
    const std::uint8_t* __restrict q = p + image.step[0];
    for (int j = 0; j < kPatchSize; ++j) {
      out[j] = w00 * p[j] + w01 * p[j + 1] + w10 * q[j] + w11 * q[j + 1];
    }
    out += kPatchSize;
  }
}

bool patchInside(const cv::Mat& image, float x, float y) {
  return x >= kPatchHalf && y >= kPatchHalf &&
         x < static_cast<float>(image.cols - kPatchHalf - 1) &&
         y < static_cast<float>(image.rows - kPatchHalf - 1);
}

/// Columns of the Jacobian: N spatial, then the patch (gain, optional), then one (offset).
template <int N>
struct Template {
  alignas(32) float value[kPatchArea];
  alignas(32) float jacobian[N][kPatchArea];
};

template <int N>
Template<N> makeTemplate(const WarpedPatch& patch, const Vec2& direction) {
  Template<N> t;
  const float dirx = static_cast<float>(direction.x()), diry = static_cast<float>(direction.y());
  for (int i = 0, n = 0; i < kPatchSize; ++i) {
    const float* row = patch.bordered.data() + (i + 1) * kBorderedSize + 1;
    for (int j = 0; j < kPatchSize; ++j, ++n) {
      const float dx = 0.5f * (row[j + 1] - row[j - 1]);
      const float dy = 0.5f * (row[j + kBorderedSize] - row[j - kBorderedSize]);
      t.value[n] = row[j];
      if constexpr (N == 2) {
        t.jacobian[0][n] = dx;
        t.jacobian[1][n] = dy;
      } else {
        t.jacobian[0][n] = dirx * dx + diry * dy;
      }
    }
  }
  return t;
}

inline float dot(const float* __restrict a, const float* __restrict b) {
  float lanes[8] = {};
  for (int i = 0; i < kPatchArea; i += 8) {
    for (int k = 0; k < 8; ++k) lanes[k] += a[i + k] * b[i + k];
  }
  return ((lanes[0] + lanes[1]) + (lanes[2] + lanes[3])) +
         ((lanes[4] + lanes[5]) + (lanes[6] + lanes[7]));
}

/// Gauss-Newton over N translations, gain and offset. Gain and offset are eliminated by making the
/// template zero-mean and the Jacobian orthogonal to one and, with gain, to the template
/// (variable projection), so that only an N x N system is left.
template <int N>
class Aligner {
 public:
  Aligner(const WarpedPatch& patch, const Vec2& direction, const FeatureAlignmentParameters& p)
      : parameters_(p), template_(makeTemplate<N>(patch, direction)) {
    centre(template_.value);
    energy_ = dot(template_.value, template_.value);
    gain_ = p.estimate_gain && energy_ > 64.0f;
    for (auto& column : template_.jacobian) {
      centre(column);
      if (gain_) removeTemplate(column);
    }
    Eigen::Matrix<double, N, N> H;
    for (int i = 0; i < N; ++i) along_template_[i] = dot(template_.jacobian[i], template_.value);
    for (int i = 0; i < N; ++i)
      for (int j = 0; j < N; ++j) H(i, j) = dot(template_.jacobian[i], template_.jacobian[j]);
    solver_.compute(H);
    usable_ = H.trace() > 1.0 && H.determinant() > 1e-3 * std::pow(H.trace() / N, N) * 1e-2;
  }

  AlignmentResult run(const cv::Mat& image, const Vec2& start, const Vec2& direction) const {
    AlignmentResult result;
    result.px = start;
    if (!usable_) return result;
    alignas(32) float residual[kPatchArea];
    float gain = 1;
    auto x = static_cast<float>(start.x()), y = static_cast<float>(start.y());
    const double min_step2 = parameters_.min_step_px * parameters_.min_step_px;
    for (int it = 0; it < parameters_.max_iterations; ++it) {
      if (!patchInside(image, x, y)) return result;
      samplePatch(image, x, y, residual);
      centre(residual);
      if (gain_) gain = dot(residual, template_.value) / energy_;
      if (!(gain > 0.3f && gain < 3.0f)) return result;
      Eigen::Matrix<double, N, 1> b;
      for (int i = 0; i < N; ++i)
        b[i] = dot(template_.jacobian[i], residual) / gain - along_template_[i];
      const Eigen::Matrix<double, N, 1> step = solver_.solve(b);
      if constexpr (N == 2) {
        x -= static_cast<float>(step[0]);
        y -= static_cast<float>(step[1]);
      } else {
        x -= static_cast<float>(step[0] * direction.x());
        y -= static_cast<float>(step[0] * direction.y());
      }
      result.iterations = it + 1;
      if (step.squaredNorm() < min_step2) {
        result.converged = true;
        break;
      }
    }
    if (!result.converged || !patchInside(image, x, y)) {
      result.converged = false;
      return result;
    }
    result.px = Vec2(x, y);
    result.rms = finalRms(residual, gain);
    result.converged = result.rms <= parameters_.max_mean_error;
    return result;
  }

 private:
  static void centre(float* v) {
    float sum = 0;
    for (int i = 0; i < kPatchArea; ++i) sum += v[i];
    const float mean = sum / kPatchArea;
    for (int i = 0; i < kPatchArea; ++i) v[i] -= mean;
  }
  void removeTemplate(float* v) const {
    const float k = dot(v, template_.value) / energy_;
    for (int i = 0; i < kPatchArea; ++i) v[i] -= k * template_.value[i];
  }
  double finalRms(const float* residual, float gain) const {
    double sum = 0;
    for (int i = 0; i < kPatchArea; ++i) {
      const double r = residual[i] - gain * template_.value[i];
      sum += r * r;
    }
    return std::sqrt(sum / kPatchArea);
  }

  const FeatureAlignmentParameters& parameters_;
  Template<N> template_;
  Eigen::Matrix<double, N, 1> along_template_;  ///< Jacobian times template; zero with gain
  float energy_ = 0;
  bool gain_ = false, usable_ = false;
  Eigen::LDLT<Eigen::Matrix<double, N, N>> solver_;
};

}  // namespace

AlignmentResult alignPatch2D(const cv::Mat& image, const WarpedPatch& patch, const Vec2& px,
                             const FeatureAlignmentParameters& parameters) {
  return Aligner<2>(patch, Vec2::Zero(), parameters).run(image, px, Vec2::Zero());
}

AlignmentResult alignPatch1D(const cv::Mat& image, const WarpedPatch& patch, const Vec2& px,
                             const Vec2& direction, const FeatureAlignmentParameters& parameters) {
  return Aligner<1>(patch, direction, parameters).run(image, px, direction);
}

}  // namespace svoscope
