// SPDX-License-Identifier: MIT
#include "engine/tracking/segment_pose.h"

#include <algorithm>
#include <cmath>

namespace svoscope {

namespace {
constexpr double kTukey = 4.685;
}

bool segmentResiduals(const Pinhole& camera, const SegmentPoseObservation& o, const SE3& T,
                      double (&e)[2]) {
  for (int i = 0; i < 2; ++i) {
    const Vec3 p = T * o.p_world[i];
    if (p.z() < 1e-3) return false;
    e[i] = o.line.distance(camera.project(p));
    if (!std::isfinite(e[i])) return false;
  }
  return true;
}

double segmentScale(const Pinhole& camera, const std::vector<SegmentPoseObservation>& observations,
                    const SE3& T, double min_scale) {
  std::vector<double> errors;
  double e[2];
  for (const SegmentPoseObservation& o : observations) {
    if (!o.informs || !segmentResiduals(camera, o, T, e)) continue;
    for (int i = 0; i < 2; ++i) errors.push_back(std::abs(e[i]) / o.sigma[i]);
  }
  if (errors.empty()) return min_scale;
  const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
  std::nth_element(errors.begin(), middle, errors.end());
  return std::max(min_scale, 1.48 * *middle);
}

void addSegmentTerms(const Pinhole& camera, const std::vector<SegmentPoseObservation>& observations,
                     const SE3& T, double scale, double pose_sigma, Mat6& H, Vec6& b) {
  double e[2];
  for (const SegmentPoseObservation& o : observations) {
    if (!o.informs || !segmentResiduals(camera, o, T, e)) continue;
    for (int i = 0; i < 2; ++i) {
      const double s = scale * o.sigma[i], u = e[i] / (kTukey * s);
      if (std::abs(u) >= 1) continue;
      const double w = std::pow((1 - u * u) / (s * pose_sigma), 2);
      const Row6 J = lineTwistJacobian(camera, T * o.p_world[i], o.line.normal);
      H += w * J.transpose() * J;
      b -= w * e[i] * J.transpose();
    }
  }
}

}  // namespace svoscope
