// SPDX-License-Identifier: MIT
// One pyramid level of sparse image alignment: patches of the reference image, and the normal
// equations of their photometric error in the current one (inverse compositional). Used by
// sparse_alignment.cpp.
#pragma once

#include <vector>

#include "engine/tracking/sparse_alignment.h"

namespace svoscope {

constexpr int kAlignmentSide = 4, kAlignmentArea = kAlignmentSide * kAlignmentSide;
constexpr int kAlignmentParameters = 8;  ///< twist (6), gain, offset

using Mat8 = Eigen::Matrix<double, kAlignmentParameters, kAlignmentParameters>;
using Vec8 = Eigen::Matrix<double, kAlignmentParameters, 1>;

/// One reference patch on one level.
struct LevelPatch {
  Vec3 p_ref;
  alignas(32) float value[kAlignmentArea];
  alignas(32) float jacobian[kAlignmentParameters][kAlignmentArea];
  float hessian[kAlignmentParameters][kAlignmentParameters];
};

struct AlignmentState {
  SE3 T_cur_ref;
  double gain = 1, offset = 0;
};

struct AlignmentNormal {
  Mat8 H = Mat8::Zero();
  Vec8 b = Vec8::Zero();
  double error = 0, weight = 0;  ///< weighted squared error and weight, per pixel
  int visible = 0;
};

class LevelAligner {
 public:
  /// The images must outlive the aligner.
  LevelAligner(const Pyramid& ref, const Pyramid& cur, const Pinhole& camera, int level)
      : image_ref_(ref[level]), image_cur_(cur[level]), camera_(camera), level_(level) {}

  void addPatches(const std::vector<AlignmentPatch>& sources);
  std::size_t size() const { return patches_.size(); }
  /// Sets the robust scale from the errors at `state`.
  void setScale(const AlignmentState& state);
  AlignmentNormal linearize(const AlignmentState& state) const;
  /// Image motion of a twist, px of this level, for a typical point.
  double motionPx(const Vec8& step) const;

 private:
  /// Calls f(patch, residuals, their squared sum) for every patch that lies inside the current
  /// image.
  template <typename Visit>
  void visit(const AlignmentState& state, const Visit& f) const;

  const cv::Mat& image_ref_;
  const cv::Mat& image_cur_;
  const Pinhole& camera_;
  int level_;
  double scale_ = 10;
  std::vector<LevelPatch> patches_;
};

}  // namespace svoscope
