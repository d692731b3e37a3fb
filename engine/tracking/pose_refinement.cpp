// SPDX-License-Identifier: MIT
#include "engine/tracking/pose_refinement.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/quantile.h"
#include "engine/tracking/sparse_alignment.h"

namespace svoscope {

namespace {

constexpr double kTukey = 4.685;
constexpr double kBehind = 1e9;  // error of a point behind the camera

struct Residual {
  Vec2 e = Vec2::Zero();  ///< measured - projected, px; edgelets: (along gradient, 0)
  bool valid = false;
};

Residual residualOf(const Pinhole& camera, const PoseObservation& o, const SE3& T_cam_world) {
  Residual r;
  const Vec3 p = T_cam_world * o.p_world;
  if (p.z() < 1e-3) return r;
  r.e = o.px - camera.project(p);
  if (o.type == FeatureType::edgelet) r.e = Vec2(o.gradient_dir.dot(r.e), 0);
  r.valid = r.e.allFinite();
  return r;
}

double sigmaOf(const PoseObservation& o, const PoseRefinementParameters& p) {
  double sigma = 1 << o.level;
  if (o.type == FeatureType::edgelet) sigma *= p.edgelet_sigma;
  return sigma;
}

/// Inverse of sigma^2 I + depth_px depth_px^T; of an edgelet, (0, 0) holds the one along its
/// gradient.
Mat2 informationOf(const PoseObservation& o, double sigma) {
  const double s2 = sigma * sigma;
  Mat2 W = Mat2::Zero();
  if (o.type == FeatureType::edgelet) {
    const double d = o.gradient_dir.dot(o.depth_px);
    W(0, 0) = 1 / (s2 + d * d);
    return W;
  }
  const Vec2& d = o.depth_px;
  return (Mat2::Identity() - d * d.transpose() / (s2 + d.squaredNorm())) / s2;
}

/// Length of the error in sigmas.
double lengthOf(const Residual& r, const Mat2& information) {
  return std::sqrt(r.e.dot(information * r.e));
}

double robustScale(const Pinhole& camera, const std::vector<PoseObservation>& observations,
                   const SE3& T, const PoseRefinementParameters& p) {
  std::vector<double> errors;
  for (const PoseObservation& o : observations) {
    const Residual r = residualOf(camera, o, T);
    if (r.valid) errors.push_back(lengthOf(r, informationOf(o, sigmaOf(o, p))));
  }
  return std::max(p.min_scale_px, 1.48 * upperMedian(std::move(errors)));
}

double tukeyWeight(double x) {
  const double u = x / kTukey;
  if (u >= 1) return 0;
  const double v = 1 - u * u;
  return v * v;
}

struct NormalEquations {
  Mat6 H = Mat6::Zero();
  Vec6 b = Vec6::Zero();
};

NormalEquations linearize(const Pinhole& camera, const std::vector<PoseObservation>& observations,
                          const SE3& T, double scale, const PoseRefinementParameters& p) {
  NormalEquations n;
  for (const PoseObservation& o : observations) {
    const Residual r = residualOf(camera, o, T);
    if (!r.valid) continue;
    const Mat2 W = informationOf(o, scale * sigmaOf(o, p));
    const double w = tukeyWeight(lengthOf(r, W));
    if (w <= 0) continue;
    const Mat26 J = pixelTwistJacobian(camera, T * o.p_world);
    if (o.type == FeatureType::edgelet) {
      const Eigen::Matrix<double, 1, 6> j = o.gradient_dir.transpose() * J;
      n.H += w * W(0, 0) * j.transpose() * j;
      n.b += w * W(0, 0) * j.transpose() * r.e.x();
    } else {
      n.H += w * J.transpose() * W * J;
      n.b += w * J.transpose() * W * r.e;
    }
  }
  return n;
}

void classify(const Pinhole& camera, const std::vector<PoseObservation>& observations,
              const PoseRefinementParameters& p, PoseRefinementResult& result) {
  std::vector<double> inlier_errors;
  for (std::size_t i = 0; i < observations.size(); ++i) {
    const PoseObservation& o = observations[i];
    const Residual r = residualOf(camera, o, result.T_cam_world);
    const double px = 1 << o.level;
    const double e = r.valid ? px * lengthOf(r, informationOf(o, px)) : kBehind;
    result.error_px[i] = e;
    result.inlier[i] = e <= p.max_error_px * px;
    if (result.inlier[i]) inlier_errors.push_back(e);
  }
  result.inliers = static_cast<int>(inlier_errors.size());
  result.median_px = upperMedian(std::move(inlier_errors));
}

void classifySegments(const Pinhole& camera, const std::vector<SegmentPoseObservation>& segments,
                      const SegmentParameters& p, PoseRefinementResult& result) {
  for (const SegmentPoseObservation& o : segments) {
    double e[2] = {kBehind, kBehind};
    segmentResiduals(camera, o, result.T_cam_world, e);
    const double worst = std::max(std::abs(e[0]), std::abs(e[1]));
    result.segment_error_px.push_back(std::sqrt(0.5 * (e[0] * e[0] + e[1] * e[1])));
    const double sigma = std::max(o.sigma[0], o.sigma[1]);
    const bool fits =
        worst <= (o.informs ? p.max_error_px : 3 * p.line_noise_px) * std::max(1.0, sigma);
    result.segment_inlier.push_back(fits);
    result.segment_inliers += fits && o.informs;
  }
}

}  // namespace

PoseRefinementResult refinePose(const Pinhole& camera,
                                const std::vector<PoseObservation>& observations, const SE3& T_init,
                                const PoseRefinementParameters& p,
                                const std::vector<SegmentPoseObservation>& segments,
                                const SegmentParameters& segment_p) {
  PoseRefinementResult result;
  result.T_cam_world = T_init;
  result.error_px.assign(observations.size(), 0);
  result.inlier.assign(observations.size(), 0);
  if (observations.size() + segments.size() < 6) {
    result.segment_error_px.assign(segments.size(), 0);
    result.segment_inlier.assign(segments.size(), 0);
    return result;
  }
  result.scale_px = robustScale(camera, observations, T_init, p);
  result.segment_scale = segmentScale(camera, segments, T_init, segment_p.min_scale);
  bool solved = true;
  for (int it = 0; it < p.max_iterations; ++it) {
    // The initial errors hold the prediction's error too: take the scale again once it is gone.
    if (it == 3) {
      result.scale_px = robustScale(camera, observations, result.T_cam_world, p);
      result.segment_scale =
          segmentScale(camera, segments, result.T_cam_world, segment_p.min_scale);
    }
    NormalEquations n = linearize(camera, observations, result.T_cam_world, result.scale_px, p);
    addSegmentTerms(camera, segments, result.T_cam_world,
                    result.segment_scale * segment_p.line_noise_px, segment_p.pose_sigma, n.H, n.b);
    Mat6 damped = n.H;
    damped.diagonal() *= 1.0 + 1e-9;
    const Vec6 step = damped.ldlt().solve(n.b);
    if (!(solved = step.allFinite())) break;
    result.T_cam_world = SE3::exp(step) * result.T_cam_world;
    result.information = n.H;
    if (it > 3 && step.norm() < 1e-8) break;
  }
  result.ok = solved && result.T_cam_world.finite();
  classify(camera, observations, p, result);
  classifySegments(camera, segments, segment_p, result);
  return result;
}

}  // namespace svoscope
