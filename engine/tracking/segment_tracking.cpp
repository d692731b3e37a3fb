// SPDX-License-Identifier: MIT
#include "engine/tracking/segment_tracking.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_set>

#include "engine/mapping/segment_alignment.h"
#include "engine/mapping/segment_refinement.h"

namespace svoscope {

namespace {

constexpr double kLeastVisiblePx = 25;  // shorter visible parts fix no direction
constexpr double kMinViewCosine = 0.5;  // between reference and current view of the middle

struct Candidate {
  const SegmentLandmark* landmark = nullptr;
  const SegmentSeed* seed = nullptr;
  TrackedSegment segment;
  int rank = 0;
  double length = 0;
};

bool before(const Candidate& a, const Candidate& b) {
  return std::make_tuple(a.landmark == nullptr, -a.rank, -a.length, a.segment.id) <
         std::make_tuple(b.landmark == nullptr, -b.rank, -b.length, b.segment.id);
}

/// Sigma across the image line caused by the end points' covariances at parameter t, px.
double depthSigma(const Pinhole& camera, const TrackedSegment& s, double t, const SE3& T,
                  const Vec2& normal) {
  const Row3 J = linePointJacobian(camera, T * s.pointAt(t), T.rotation(), normal);
  const Mat3 C = (1 - t) * (1 - t) * s.covariance[0] + t * t * s.covariance[1];
  return std::sqrt(std::max(0.0, (J * C * J.transpose()).value()));
}

class SegmentTracking {
 public:
  SegmentTracking(const Map& map, const Frame& frame, const MappingParameters& m)
      : map_(map),
        frame_(frame),
        mapping_(m),
        p_(m.segments),
        c_world_(frame.T_cam_world.inverse().translation()) {}

  SegmentTrackingResult run(const std::vector<int>& local_keyframes) {
    collect(local_keyframes);
    std::sort(candidates_.begin(), candidates_.end(), before);
    out_.projected = static_cast<int>(candidates_.size());
    for (Candidate& c : candidates_) {
      if (static_cast<int>(out_.segments.size()) >= p_.max_tracked || out_.tried >= p_.max_tries)
        break;
      const auto taken = [&](const TrackedSegment& s) {
        return sameEdge(s.anchor.px, c.segment.predicted, 5, 0.7 * p_.detector.separation_px, 0.3);
      };
      if (std::any_of(out_.segments.begin(), out_.segments.end(), taken)) continue;
      ++out_.tried;
      tryCandidate(c);
    }
    return std::move(out_);
  }

 private:
  void collect(const std::vector<int>& local_keyframes) {
    std::unordered_set<std::int64_t> seen;
    for (const int id : local_keyframes) {
      const Keyframe* keyframe = map_.findKeyframe(id);
      if (!keyframe) continue;
      for (const std::int64_t segment_id : keyframe->segments) {
        if (seen.insert(segment_id).second) addLandmark(map_.segments.at(segment_id));
      }
      for (const SegmentSeed& seed : keyframe->segment_seeds) addSeed(seed, *keyframe);
    }
  }

  void addLandmark(const SegmentLandmark& landmark) {
    Candidate c;
    c.landmark = &landmark;
    c.segment.id = landmark.id;
    c.rank = std::min(landmark.succeeded - 2 * landmark.failed, 20);
    for (int i = 0; i < 2; ++i) {
      c.segment.p_world[i] = landmark.p_world[i];
      c.segment.covariance[i] = landmark.covariance[i];
    }
    addVisible(c);
  }

  void addSeed(const SegmentSeed& seed, const Keyframe& keyframe) {
    if (!alive(seed)) return;
    const bool converged = seed.status == SeedStatus::converged;
    Candidate c;
    c.seed = &seed;
    c.segment.id = seed.id;
    c.segment.keyframe_id = keyframe.id;
    c.segment.origin = converged ? FeatureOrigin::converged_seed : FeatureOrigin::unconverged_seed;
    c.rank = converged;
    setSeedPose(seed, keyframe, c.segment);
    addVisible(c);
  }

  /// Keeps a candidate whose visible part is long enough and whose place across the line is known.
  void addVisible(Candidate& c) {
    ++out_.candidates;
    TrackedSegment& s = c.segment;
    const Vec3 p0 = frame_.T_cam_world * s.p_world[0], p1 = frame_.T_cam_world * s.p_world[1];
    if (!clipToImage(map_.camera, p0, p1, 9, s.t[0], s.t[1])) return;
    for (int i = 0; i < 2; ++i)
      s.predicted[i] = map_.camera.project(frame_.T_cam_world * s.pointAt(s.t[i]));
    c.length = (s.predicted[1] - s.predicted[0]).norm();
    if (c.length < kLeastVisiblePx) return;
    const Vec2 normal = lineThrough(s.predicted[0], s.predicted[1]).normal;
    for (const double t : s.t) {
      if (depthSigma(map_.camera, s, t, frame_.T_cam_world, normal) > p_.max_prediction_px) return;
    }
    candidates_.push_back(c);
  }

  /// The view with the most similar direction onto the middle of the segment.
  const SegmentView* closestSegmentView(const SegmentLandmark& landmark) const {
    const Vec3 middle = 0.5 * (landmark.p_world[0] + landmark.p_world[1]);
    const Vec3 direction = (c_world_ - middle).normalized();
    const SegmentView* best = nullptr;
    double best_cosine = kMinViewCosine;
    for (const SegmentView& view : landmark.views) {
      const Keyframe* keyframe = map_.findKeyframe(view.keyframe_id);
      if (!keyframe) continue;
      const Vec3 c = keyframe->T_cam_world.inverse().translation();
      const double cosine = direction.dot((c - middle).normalized());
      if (cosine > best_cosine) best_cosine = cosine, best = &view;
    }
    return best;
  }

  bool align(Candidate& c) {
    TrackedSegment& s = c.segment;
    const SegmentAnchor* anchor = c.seed ? &c.seed->anchor : nullptr;
    if (c.landmark) {
      const SegmentView* view = closestSegmentView(*c.landmark);
      if (!view) return false;
      s.keyframe_id = view->keyframe_id;
      anchor = &view->anchor;
    }
    const Keyframe& keyframe = *map_.findKeyframe(s.keyframe_id);
    SegmentQuery q;
    q.ref = keyframe.pyramid.get();
    q.cur = frame_.pyramid.get();
    q.camera = map_.camera;
    q.T_cur_ref = frame_.T_cam_world * keyframe.T_cam_world.inverse();
    q.anchor = *anchor;
    for (int i = 0; i < 2; ++i) q.p_ref[i] = keyframe.T_cam_world * s.p_world[i];
    const SegmentAlignment a = alignSegment(q, p_, mapping_.alignment);
    if (!a.ok) return false;
    for (int i = 0; i < 2; ++i) {
      s.t[i] = a.t[i];
      s.predicted[i] = a.predicted[i];
      s.anchor.px[i] = a.px[i];
      s.anchor.f[i] = map_.camera.bearing(a.px[i]);
    }
    s.anchor.level = a.level;
    return true;
  }

  void tryCandidate(Candidate& c) {
    const bool ok = align(c);
    if (!ok) c.segment.status = FeatureStatus::not_aligned;
    (ok ? out_.segments : out_.failed).push_back(c.segment);
  }

  const Map& map_;
  const Frame& frame_;
  const MappingParameters& mapping_;
  const SegmentParameters& p_;
  Vec3 c_world_;
  std::vector<Candidate> candidates_;
  SegmentTrackingResult out_;
};

}  // namespace

SegmentTrackingResult trackSegments(const Map& map, const Frame& frame,
                                    const std::vector<int>& local_keyframes,
                                    const MappingParameters& parameters) {
  if (!parameters.segments.enabled) return {};
  return SegmentTracking(map, frame, parameters).run(local_keyframes);
}

void setSeedPose(const SegmentSeed& seed, const Keyframe& keyframe, TrackedSegment& s) {
  const SE3 T_world_kf = keyframe.T_cam_world.inverse();
  for (int i = 0; i < 2; ++i) {
    s.p_world[i] = T_world_kf * (seed.anchor.f[i] / seed.belief[i].mu);
    s.covariance[i] = seedEndCovariance(seed, i, keyframe.T_cam_world);
  }
}

std::vector<SegmentPoseObservation> segmentObservations(const Pinhole& camera,
                                                        const std::vector<TrackedSegment>& segments,
                                                        const SE3& T_cam_world,
                                                        const SegmentParameters& p) {
  std::vector<SegmentPoseObservation> observations;
  observations.reserve(segments.size());
  for (const TrackedSegment& s : segments) {
    SegmentPoseObservation o;
    o.line = lineThrough(s.anchor.px[0], s.anchor.px[1]);
    for (int i = 0; i < 2; ++i) {
      o.p_world[i] = s.pointAt(s.t[i]);
      const double line_sigma = p.line_noise_px * (1 << s.anchor.level);
      const double depth_px = depthSigma(camera, s, s.t[i], T_cam_world, o.line.normal);
      o.sigma[i] = std::hypot(line_sigma, depth_px) / p.line_noise_px;
      // The error of a depth is the same in every frame: weighing it down does not average it out.
      if (depth_px > p.max_depth_px) o.informs = false;
    }
    observations.push_back(o);
  }
  return observations;
}

void appendPatchesAlong(const Pinhole& camera, const Vec3& p0, const Vec3& p1,
                        const ImageLine& line, int count, std::vector<AlignmentPatch>& patches) {
  for (int i = 0; i < count; ++i) {
    const double u = (i + 0.5) / count;
    const Vec3 q = (1 - u) * p0 + u * p1;
    if (q.z() < 1e-3) continue;
    const Vec2 px = line.closest(camera.project(q));
    patches.push_back({px, camera.bearing(px) * q.norm()});
  }
}

void appendSegmentPatches(const Pinhole& camera, const Frame& frame, const SegmentParameters& p,
                          std::vector<AlignmentPatch>& patches) {
  const std::size_t most = patches.size() + static_cast<std::size_t>(std::max(0, p.max_patches));
  for (const TrackedSegment& s : frame.segments) {
    if (s.status != FeatureStatus::inlier || s.origin == FeatureOrigin::unconverged_seed) continue;
    const int count = std::min(p.patches_per_segment, static_cast<int>(most - patches.size()));
    appendPatchesAlong(camera, frame.T_cam_world * s.pointAt(s.t[0]),
                       frame.T_cam_world * s.pointAt(s.t[1]),
                       lineThrough(s.anchor.px[0], s.anchor.px[1]), count, patches);
  }
}

}  // namespace svoscope
