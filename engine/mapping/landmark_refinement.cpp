// SPDX-License-Identifier: MIT
#include "engine/mapping/landmark_refinement.h"

#include <Eigen/Cholesky>
#include <limits>

namespace svoscope {

namespace {

/// Error and normal equations of all views; infinite error if the point is behind one.
double linearize(const Landmark& landmark, const Map& map, const Vec3& p_world, Mat3& H, Vec3& b) {
  H.setZero();
  b.setZero();
  double error = 0;
  for (const LandmarkObservation& o : landmark.observations) {
    const auto it = map.keyframes.find(o.keyframe_id);
    if (it == map.keyframes.end()) continue;
    const SE3& T = it->second.T_cam_world;
    const Vec3 p = T * p_world;
    if (p.z() < 1e-6) return std::numeric_limits<double>::infinity();
    const Vec2 e = o.anchor.f.head<2>() / o.anchor.f.z() - p.head<2>() / p.z();
    const double weight = 1.0 / (1 << (2 * o.anchor.level));
    Mat23 J;
    J << 1 / p.z(), 0, -p.x() / (p.z() * p.z()), 0, 1 / p.z(), -p.y() / (p.z() * p.z());
    const Mat23 Jw = J * T.rotation();
    H += weight * Jw.transpose() * Jw;
    b += weight * Jw.transpose() * e;
    error += weight * e.squaredNorm();
  }
  return error;
}

}  // namespace

bool refineLandmark(Landmark& landmark, const Map& map, int max_iterations) {
  if (landmark.type != FeatureType::corner || landmark.observations.size() < 2) return false;
  Mat3 H;
  Vec3 b;
  Vec3 p = landmark.p_world;
  double error = linearize(landmark, map, p, H, b);
  bool changed = false;
  for (int it = 0; it < max_iterations; ++it) {
    const Vec3 step = H.ldlt().solve(b);
    if (!step.allFinite()) break;
    Mat3 H_next;
    Vec3 b_next;
    const double next = linearize(landmark, map, p + step, H_next, b_next);
    if (!(next < error)) break;
    p += step;
    H = H_next;
    b = b_next;
    changed = true;
    const bool done = error - next < 1e-6 * error;
    error = next;
    if (done) break;
  }
  if (changed) landmark.p_world = p;
  return changed;
}

}  // namespace svoscope
