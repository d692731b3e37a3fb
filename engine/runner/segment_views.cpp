// SPDX-License-Identifier: MIT
#include "engine/runner/segment_views.h"

#include <algorithm>
#include <cmath>

namespace svoscope {

namespace {

float trueInverseDistance(const cv::Mat& depth, const SegmentAnchor& anchor) {
  const int x = static_cast<int>(std::lround(anchor.px[0].x())),
            y = static_cast<int>(std::lround(anchor.px[0].y()));
  if (depth.empty() || x < 0 || y < 0 || x >= depth.cols || y >= depth.rows) return 0;
  const float z = depth.at<float>(y, x);
  return z > 0 ? static_cast<float>(anchor.f[0].z()) / z : 0;
}

}  // namespace

FeatureView segmentFeatureView(const TrackedSegment& s, const Tracker& tracker) {
  FeatureView v;
  v.id = s.id;
  v.type = FeatureType::segment;
  v.origin = s.origin;
  v.status = s.status == FeatureStatus::inlier && !s.informs ? FeatureStatus::followed : s.status;
  v.level = static_cast<std::uint8_t>(s.anchor.level);
  const bool aligned = s.status != FeatureStatus::not_aligned;
  v.px = (aligned ? s.anchor.px[0] : s.predicted[0]).cast<float>();
  v.px_end = (aligned ? s.anchor.px[1] : s.predicted[1]).cast<float>();
  const Vec3 p = tracker.frame().T_cam_world * s.pointAt(s.t[0]);
  v.predicted_px = s.predicted[0].cast<float>();
  if (aligned && p.z() > 1e-6) v.predicted_px = tracker.map().camera.project(p).cast<float>();
  const Vec2f along = v.px_end - v.px;
  v.direction = std::atan2(along.x(), -along.y());
  v.depth =
      static_cast<float>((tracker.frame().T_cam_world * s.pointAt(0.5 * (s.t[0] + s.t[1]))).z());
  v.residual_px = static_cast<float>(s.error_px);
  v.reference_keyframe = s.keyframe_id;
  const auto it = tracker.map().segments.find(s.id);
  if (s.origin == FeatureOrigin::landmark && it != tracker.map().segments.end())
    v.observations = static_cast<int>(it->second.views.size());
  return v;
}

SeedView segmentSeedView(const SegmentSeed& seed, const Tracker& tracker,
                         const SeedPlacement& placement, const cv::Mat& depth) {
  SeedView v;
  v.id = seed.id;
  v.keyframe_id = seed.keyframe_id;
  v.type = FeatureType::segment;
  v.status = seed.status;
  v.ending = seed.ending;
  v.outcome = seed.outcome;
  v.level = static_cast<std::uint8_t>(seed.anchor.level);
  v.px_ref = seed.anchor.px[0].cast<float>();
  v.px_ref_end = seed.anchor.px[1].cast<float>();
  const auto sigma = [&](int i) { return std::sqrt(seed.belief[i].sigma2); };
  v.mu = static_cast<float>(seed.belief[0].mu);
  v.sigma = static_cast<float>(sigma(0));
  v.mu_end = static_cast<float>(seed.belief[1].mu);
  v.sigma_end = static_cast<float>(sigma(1));
  v.a = static_cast<float>(seed.belief[0].a);
  v.b = static_cast<float>(seed.belief[0].b);
  v.belief[tracker.parameters().mapping.filter.rule] = {v.mu, v.sigma, v.a, v.b};
  v.range = static_cast<float>(seed.range);
  v.updates = seed.updates;
  v.failures = seed.failures;
  v.last_x = static_cast<float>(seed.last_x[0]);
  v.last_tau = static_cast<float>(seed.last_tau[0]);
  placeSeed(v, placement);
  v.true_inv_distance = trueInverseDistance(depth, seed.anchor);
  return v;
}

MapPointView segmentPointView(const SegmentLandmark& s) {
  MapPointView v;
  v.id = s.id;
  v.type = FeatureType::segment;
  v.position = s.p_world[0].cast<float>();
  v.position_end = s.p_world[1].cast<float>();
  v.sigma = static_cast<float>(std::max(s.prior_sigma[0], s.prior_sigma[1]));
  v.observations = static_cast<int>(s.views.size());
  v.reference_keyframe = s.views.empty() ? -1 : s.views.front().keyframe_id;
  return v;
}

}  // namespace svoscope
