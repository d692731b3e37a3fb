// SPDX-License-Identifier: MIT
// 8x8 patches: bilinear sampling, and warping from a reference view by a local affine map.
#pragma once

#include <array>
#include <cstdint>
#include <opencv2/core/mat.hpp>

#include "engine/base/types.h"
#include "engine/geometry/camera.h"
#include "engine/geometry/se3.h"

namespace svoscope {

constexpr int kPatchSize = 8;
constexpr int kPatchHalf = kPatchSize / 2;
constexpr int kPatchArea = kPatchSize * kPatchSize;
constexpr int kBorderedSize = kPatchSize + 2;

/// Reference patch with a border of one pixel for its gradients, grey levels, row major. Pixel
/// (i, j) of the inner 8x8 sits at offset (j - 4, i - 4) from the feature.
struct WarpedPatch {
  std::array<float, kBorderedSize * kBorderedSize> bordered{};
  float inner(int row, int column) const {
    return bordered[static_cast<std::size_t>((row + 1) * kBorderedSize + column + 1)];
  }
};

/// Bilinear value at (x, y); the caller guarantees 0 <= x < cols - 1, 0 <= y < rows - 1.
inline float bilinear(const cv::Mat& image, float x, float y) {
  const int xi = static_cast<int>(x), yi = static_cast<int>(y);
  const float sx = x - static_cast<float>(xi), sy = y - static_cast<float>(yi);
  const std::uint8_t* p = image.ptr<std::uint8_t>(yi) + xi;
  const std::uint8_t* q = p + image.step[0];
  return (1 - sy) * ((1 - sx) * p[0] + sx * p[1]) + sy * ((1 - sx) * q[0] + sx * q[1]);
}

/// How the surroundings of a pixel in the reference view appear in the current view, for a surface
/// patch facing the reference camera at distance `distance` along bearing `f_ref` (unit).
/// d px_cur / d px_ref, both at level 0.
Mat2 affineWarp(const Pinhole& camera, const SE3& T_cur_ref, const Vec3& f_ref, double distance);

/// Level of the current pyramid at which the warped patch has about the reference's resolution:
/// one up while the area factor exceeds 3. `A_cur_ref` is d px_cur / d px_ref at level 0.
int searchLevel(const Mat2& A_cur_ref, int level_ref, int max_level);

/// Samples the reference pyramid level `level_ref` around level-0 pixel `px_ref` such that the
/// patch looks as on level `level_cur` of the current view. False if it leaves the reference image.
bool warpPatch(const cv::Mat& image_ref, const Vec2& px_ref, int level_ref, const Mat2& A_cur_ref,
               int level_cur, WarpedPatch& patch);

}  // namespace svoscope
