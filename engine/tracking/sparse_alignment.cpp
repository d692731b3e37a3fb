// SPDX-License-Identifier: MIT
#include "engine/tracking/sparse_alignment.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/tracking/alignment_level.h"

namespace svoscope {

namespace {

constexpr int kLeastPatches = 8;

Vec8 solve(AlignmentNormal n, bool estimate_gain) {
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

AlignmentState applied(const AlignmentState& s, const Vec8& step) {
  AlignmentState next;
  next.T_cur_ref = s.T_cur_ref * SE3::exp(-step.head<6>());
  next.gain = std::clamp(s.gain * (1 + std::clamp(step[6], -0.5, 0.5)), 0.2, 5.0);
  next.offset = s.offset + s.gain * step[7];
  return next;
}

/// Gauss-Newton on one level; a step that raises the error is undone and ends the level. Not the
/// first: it also brings in the brightness, and the visible patches change with it; undoing it
/// costs a tenth in accuracy.
AlignmentNormal alignLevel(LevelAligner& level, const SparseAlignmentParameters& p,
                           AlignmentState& state, int& iterations) {
  level.setScale(state);
  AlignmentNormal n = level.linearize(state);
  for (int it = 0; it < p.max_iterations && n.visible >= kLeastPatches; ++it) {
    const Vec8 step = solve(n, p.estimate_gain);
    if (!step.allFinite()) break;
    const AlignmentState next = applied(state, step);
    const AlignmentNormal m = level.linearize(next);
    ++iterations;
    const bool worse =
        m.visible < kLeastPatches || m.error / m.weight > n.error / n.weight * 1.0001;
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
                        const std::vector<AlignmentPatch>& patches, const SE3& T_cur_ref,
                        int level) {
  LevelAligner aligner(ref, cur, camera, std::min<int>(level, static_cast<int>(ref.size()) - 1));
  aligner.addPatches(patches);
  AlignmentState state;
  state.T_cur_ref = T_cur_ref;
  aligner.setScale(state);
  AlignmentNormal n = aligner.linearize(state);
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
  AlignmentState state;
  state.T_cur_ref = T_init;
  const int top =
      std::min({p.max_level, static_cast<int>(ref.size()) - 1, static_cast<int>(cur.size()) - 1});
  for (int level = top; level >= std::min(p.min_level, top); --level) {
    LevelAligner aligner(ref, cur, camera, level);
    aligner.addPatches(patches);
    if (static_cast<int>(aligner.size()) < kLeastPatches) continue;
    const AlignmentNormal n = alignLevel(aligner, p, state, result.iterations);
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
