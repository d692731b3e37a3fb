// SPDX-License-Identifier: MIT
#include "engine/tracking/frame_summary.h"

#include "engine/base/quantile.h"

namespace svoscope {

namespace {

void countInliers(const Frame& frame, Funnel& funnel) {
  for (const TrackedFeature& f : frame.features) {
    if (f.status != FeatureStatus::inlier) continue;
    ++(f.origin == FeatureOrigin::landmark ? funnel.inlier_landmarks : funnel.inlier_seeds);
    funnel.inlier_edgelets += f.anchor.type == FeatureType::edgelet;
  }
  for (const TrackedSegment& s : frame.segments) {
    if (s.status != FeatureStatus::inlier) continue;
    if (!s.informs) {
      ++funnel.followed_segments;
      continue;
    }
    ++funnel.inlier_segments;
    ++(s.origin == FeatureOrigin::landmark ? funnel.inlier_landmarks : funnel.inlier_seeds);
  }
}

/// Upper median of the inliers' errors; 0 if there are none.
double medianError(const Frame& frame) {
  std::vector<double> errors;
  for (const TrackedFeature& f : frame.features) {
    if (f.status == FeatureStatus::inlier) errors.push_back(f.error_px);
  }
  return upperMedian(std::move(errors));
}

}  // namespace

bool depthStatistics(const Frame& frame, double& median, double& near) {
  std::vector<double> depths;
  for (const TrackedFeature& f : frame.features) {
    if (f.status != FeatureStatus::inlier) continue;
    const double z = (frame.T_cam_world * f.p_world).z();
    if (z > 0) depths.push_back(z);
  }
  if (depths.empty()) return false;
  median = quantile(depths, 0.5);
  near = quantile(std::move(depths), 0.05);
  return true;
}

void summarizeFrame(const Frame& frame, const Map& map, FrameRecord& record) {
  record.T_world_cam = frame.T_cam_world.inverse();
  countInliers(frame, record.funnel);
  record.reprojection_px = medianError(frame);
  double near = 0;
  depthStatistics(frame, record.median_depth, near);
  record.landmarks = static_cast<int>(map.landmarks.size() + map.segments.size());
  record.seeds = map.seedCount();
  record.keyframes = static_cast<int>(map.keyframes.size());
}

}  // namespace svoscope
