// SPDX-License-Identifier: MIT
#include "engine/tracking/registration.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/stopwatch.h"
#include "engine/tracking/segment_tracking.h"

namespace svoscope {

namespace {

/// What takes part in a search.
struct Scope {
  int coarser = 0;                ///< pyramid levels added to the search
  bool unconverged_seeds = true;  ///< found along long lines, they fit at many a wrong pose
};

/// One search from one pose, not judged yet.
struct Attempt {
  SparseAlignmentResult aligned;
  ReprojectionResult reprojected;
  SegmentTrackingResult segments;
  PoseRefinementResult pose;
  StageTimes time_ms{};

  double& ms(Stage s) { return time_ms[static_cast<std::size_t>(s)]; }
  int inliers() const { return pose.inliers + pose.segment_inliers; }
  int tried() const { return reprojected.tried + segments.tried; }
};

std::vector<PoseObservation> observationsOf(const std::vector<TrackedFeature>& features) {
  std::vector<PoseObservation> observations;
  observations.reserve(features.size());
  for (const TrackedFeature& f : features) {
    observations.push_back({f.anchor.px, f.p_believed, f.anchor.level, f.anchor.type,
                            f.anchor.gradient_dir, f.depth_px});
  }
  return observations;
}

/// Segments of the map; with them the pose is refined once more.
void addSegments(Frame& frame, const Map& map, const std::vector<PoseObservation>& observations,
                 const TrackerParameters& p, Attempt& a) {
  Stopwatch watch;
  // The points' pose predicts the lines: fewer steps, and no jump to a parallel edge.
  if (a.pose.ok && a.pose.inliers >= p.quality.min_inliers) frame.T_cam_world = a.pose.T_cam_world;
  a.segments = trackSegments(map, frame, a.reprojected.local_keyframes, p.mapping);
  a.ms(Stage::reproject) += watch.lapMs();
  if (!a.segments.segments.empty()) {
    const auto lines =
        segmentObservations(map.camera, a.segments.segments, frame.T_cam_world, p.mapping.segments);
    a.pose =
        refinePose(map.camera, observations, frame.T_cam_world, p.pose, lines, p.mapping.segments);
    for (std::size_t i = 0; i < lines.size(); ++i)
      a.segments.segments[i].informs = lines[i].informs;
  }
  a.ms(Stage::pose) += watch.lapMs();
}

Attempt attemptAt(const SE3& T_cam_world, Frame frame, const Map& map, const Scope& scope,
                  const TrackerParameters& p) {
  Attempt a;
  Stopwatch watch;
  frame.T_cam_world = T_cam_world;
  ReprojectorParameters reproject = p.reproject;
  reproject.coarser = scope.coarser;
  reproject.unconverged_seeds = reproject.unconverged_seeds && scope.unconverged_seeds;
  a.reprojected = reprojectMap(map, frame, reproject, p.mapping);
  a.ms(Stage::reproject) += watch.lapMs();
  const auto observations = observationsOf(a.reprojected.features);
  a.pose = refinePose(map.camera, observations, T_cam_world, p.pose);
  a.ms(Stage::pose) += watch.lapMs();
  if (p.mapping.segments.enabled) addSegments(frame, map, observations, p, a);
  return a;
}

/// The same once more from the pose found: the first pass finds only what lay near its prediction.
Attempt attemptAgain(const Attempt& first, const Frame& frame, const Map& map, const Scope& scope,
                     const TrackerParameters& p) {
  Attempt second = attemptAt(first.pose.T_cam_world, frame, map, scope, p);
  addTimes(first.time_ms, second.time_ms);
  return second;
}

/// What the inliers say of the pose: an edgelet is free along its edge, and two dozen of them fit
/// by chance.
int equationsOf(const PoseRefinementResult& pose, const std::vector<TrackedFeature>& features) {
  int equations = 2 * pose.segment_inliers;
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (pose.inlier[i]) equations += features[i].anchor.type == FeatureType::edgelet ? 1 : 2;
  }
  return equations;
}

/// Why an attempt is refused; empty if it is accepted.
std::string failureOf(const Attempt& a, const Funnel& funnel, const QualityParameters& q) {
  const int matched = funnel.matched, inliers = funnel.inliers, required = funnel.required;
  // Segments that are followed for their depth only have no say in the pose, so none in its
  // failure.
  const auto& segments = a.segments.segments;
  const int informing =
      matched - static_cast<int>(std::count_if(segments.begin(), segments.end(),
                                               [](const TrackedSegment& s) { return !s.informs; }));
  const int equations = a.pose.ok ? equationsOf(a.pose, a.reprojected.features) : 0;
  if (matched < required)
    return fmt::format("{} features matched of {} tried, {} required", matched, funnel.tried,
                       required);
  if (!a.pose.ok || inliers < required)
    return fmt::format("{} inliers of {} matched, {} required", inliers, matched, required);
  if (inliers < q.min_inlier_fraction * informing)
    return fmt::format("{} inliers are under {:.0f} % of {} matched", inliers,
                       100 * q.min_inlier_fraction, informing);
  if (inliers < q.min_tried_fraction * funnel.tried && equations < 2 * required)
    return fmt::format("{} inliers with {} equations are under {:.0f} % of {} tried", inliers,
                       equations, 100 * q.min_tried_fraction, funnel.tried);
  return "";
}

/// Features and segments get their errors, and are inliers or outliers.
void markInliers(const PoseRefinementResult& pose, Registration& r) {
  const auto status = [](char inlier) {
    return inlier ? FeatureStatus::inlier : FeatureStatus::outlier;
  };
  for (std::size_t i = 0; i < r.features.size(); ++i) {
    r.features[i].error_px = pose.error_px[i];
    r.features[i].status = status(pose.inlier[i]);
  }
  for (std::size_t i = 0; i < r.segments.size(); ++i) {
    r.segments[i].error_px = pose.segment_error_px[i];
    r.segments[i].status = status(pose.segment_inlier[i]);
  }
}

Registration judge(Attempt a, int required, const QualityParameters& q) {
  Registration r;
  r.judged = true;
  Funnel& funnel = r.funnel;
  funnel.aligned_sparse = a.aligned.patches;
  funnel.candidates = a.reprojected.candidates + a.segments.candidates;
  funnel.projected = a.reprojected.projected + a.segments.projected;
  funnel.tried = a.tried();
  funnel.matched = static_cast<int>(a.reprojected.features.size() + a.segments.segments.size());
  funnel.inliers = a.inliers();
  funnel.required = required;
  r.failure = failureOf(a, funnel, q);
  r.T_cam_world = a.pose.T_cam_world;
  r.noise_px = a.pose.scale_px;
  r.features = std::move(a.reprojected.features);
  r.failed_features = std::move(a.reprojected.failed);
  r.segments = std::move(a.segments.segments);
  r.failed_segments = std::move(a.segments.failed);
  r.seed_matches = std::move(a.reprojected.seed_matches);
  r.local_keyframes = std::move(a.reprojected.local_keyframes);
  r.occupied = std::move(a.reprojected.occupied);
  r.aligned = a.aligned;
  r.time_ms = a.time_ms;
  if (r.good()) markInliers(a.pose, r);
  return r;
}

}  // namespace

Registration registerFrame(const Frame& frame, const Frame& last, const Map& map,
                           const Prediction& prediction, const TrackerParameters& p) {
  const int required = p.quality.min_inliers;
  const SE3 T_init = prediction.wide ? registeredRotation(*last.pyramid, *frame.pyramid, map.camera)
                                     : prediction.T_cur_last;
  Stopwatch watch;
  const SparseAlignmentResult aligned =
      alignSparse(*last.pyramid, *frame.pyramid, map.camera,
                  alignmentPatches(last, map.camera, p.mapping.segments), T_init, p.alignment);
  const double align_ms = watch.ms();
  const SE3 T_cam_world = (aligned.ok ? aligned.T_cur_ref : T_init) * last.T_cam_world;
  // Wide: twice the capture range, then once more at the level of the features: the first finds the
  // pose.
  Attempt a = attemptAt(T_cam_world, frame, map, {prediction.wide ? 1 : 0, true}, p);
  if (prediction.wide && a.pose.ok && a.pose.inliers >= required / 2)
    a = attemptAgain(a, frame, map, {}, p);
  else
    a.aligned = aligned;
  a.ms(Stage::sparse_align) += align_ms;
  return judge(std::move(a), required, p.quality);
}

Registration relocalizeFrame(const Frame& frame, const Map& map, const SE3& T_cam_world,
                             double usual_noise_px, const TrackerParameters& p) {
  const QualityParameters& q = p.quality;
  const Scope sure = {0, false};
  Attempt a = attemptAt(T_cam_world, frame, map, sure, p);
  if (a.inliers() >= q.min_inliers) a = attemptAgain(a, frame, map, sure, p);
  constexpr double kLeastNoisePx = 0.1;  // far below it, the image is rendered or does not move
  const double most = q.relocalized_noise * std::max(usual_noise_px, kLeastNoisePx);
  if (usual_noise_px > 0 && a.pose.scale_px > most) {
    Registration refused;
    refused.failure = fmt::format("errors of {:.2f} px, {:.2f} px allowed", a.pose.scale_px, most);
    refused.time_ms = a.time_ms;
    return refused;
  }
  const int share = static_cast<int>(q.relocalized_fraction * a.tried());
  return judge(std::move(a), std::max(q.relocalized_inliers, share), q);
}

std::vector<AlignmentPatch> alignmentPatches(const Frame& frame, const Pinhole& camera,
                                             const SegmentParameters& segments) {
  std::vector<AlignmentPatch> patches;
  patches.reserve(frame.features.size());
  for (const TrackedFeature& f : frame.features) {
    if (f.status != FeatureStatus::inlier) continue;
    const Vec3 p = frame.T_cam_world * f.p_world;
    if (p.z() > 0) patches.push_back({f.anchor.px, f.anchor.f * p.norm()});
  }
  appendSegmentPatches(camera, frame, segments, patches);
  return patches;
}

void addTimes(const StageTimes& times, StageTimes& sum) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += times[i];
}

}  // namespace svoscope
