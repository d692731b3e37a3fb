// SPDX-License-Identifier: MIT
// Trying to register a frame from a predicted pose, and judging the try.
#include "engine/tracking/tracker_attempt.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/stopwatch.h"

namespace svoscope {

namespace {

std::vector<PoseObservation> observationsOf(const std::vector<TrackedFeature>& features) {
  std::vector<PoseObservation> observations;
  observations.reserve(features.size());
  for (const TrackedFeature& f : features) {
    observations.push_back({f.anchor.px, f.p_believed, f.anchor.level, f.anchor.type,
                            f.anchor.gradient_dir, f.depth_px});
  }
  return observations;
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

}  // namespace

/// Constant velocity and standing still, the one with the smaller photometric error first; then the
/// rotation between the images as wholes.
std::vector<Tracker::Prediction> Tracker::predictions(const std::vector<AlignmentPatch>& patches) {
  const int top =
      std::min<int>(parameters_.alignment.max_level, static_cast<int>(frame_.pyramid->size()) - 1);
  const auto error = [&](const SE3& T) {
    return photometricError(*last_.pyramid, *frame_.pyramid, map_.camera, patches, T, top);
  };
  std::vector<Prediction> list = {{T_velocity_, "constant velocity"}, {SE3(), "standing"}};
  if (error(T_velocity_) > error(SE3())) std::swap(list[0], list[1]);
  list.push_back({SE3(), "image registration", true});
  return list;
}

bool Tracker::trackFrom(const Prediction& prediction, const std::vector<AlignmentPatch>& patches,
                        Attempt& best) {
  const int required = parameters_.quality.min_inliers;
  if (!prediction.wide) {
    best = alignAndAttempt(patches, prediction.T_cur_prev, prediction.from, {});
    return accept(best, required);
  }
  // Twice the capture range, then once more at the level of the features: the first finds the pose.
  const SE3 T_cur_prev = registeredRotation(*last_.pyramid, *frame_.pyramid, map_.camera);
  best = alignAndAttempt(patches, T_cur_prev, prediction.from, {1, true});
  if (best.pose.ok && best.pose.inliers >= required / 2)
    best = attempt(best.T_cam_world, prediction.from, {});
  return accept(best, required);
}

Tracker::Attempt Tracker::alignAndAttempt(const std::vector<AlignmentPatch>& patches,
                                          const SE3& T_cur_prev, const char* from,
                                          const Scope& scope) {
  Stopwatch watch;
  const SparseAlignmentResult aligned = alignSparse(*last_.pyramid, *frame_.pyramid, map_.camera,
                                                    patches, T_cur_prev, parameters_.alignment);
  stageMs(record_, Stage::sparse_align) += watch.ms();
  Attempt a =
      attempt((aligned.ok ? aligned.T_cur_ref : T_cur_prev) * last_.T_cam_world, from, scope);
  a.aligned = aligned;
  return a;
}

Tracker::Attempt Tracker::attempt(const SE3& T_cam_world, const char* from, const Scope& scope) {
  Attempt a;
  a.from = from;
  Stopwatch watch;
  frame_.T_cam_world = T_cam_world;
  ReprojectorParameters reproject = parameters_.reproject;
  reproject.coarser = scope.coarser;
  reproject.unconverged_seeds = reproject.unconverged_seeds && scope.unconverged_seeds;
  a.reprojected = reprojectMap(map_, frame_, reproject, parameters_.mapping);
  stageMs(record_, Stage::reproject) += watch.lapMs();
  const auto observations = observationsOf(a.reprojected.features);
  a.pose = refinePose(map_.camera, observations, T_cam_world, parameters_.pose);
  stageMs(record_, Stage::pose) += watch.lapMs();
  if (parameters_.mapping.segments.enabled) {
    // The points' pose predicts the lines: fewer steps, and no jump to a parallel edge.
    if (a.pose.ok && a.pose.inliers >= parameters_.quality.min_inliers)
      frame_.T_cam_world = a.pose.T_cam_world;
    a.segments = trackSegments(map_, frame_, a.reprojected.local_keyframes, parameters_.mapping);
    stageMs(record_, Stage::reproject) += watch.lapMs();
    if (!a.segments.segments.empty()) {
      const auto lines = segmentObservations(map_.camera, a.segments.segments, frame_.T_cam_world,
                                             parameters_.mapping.segments);
      a.pose = refinePose(map_.camera, observations, frame_.T_cam_world, parameters_.pose, lines,
                          parameters_.mapping.segments);
      for (std::size_t i = 0; i < lines.size(); ++i)
        a.segments.segments[i].informs = lines[i].informs;
    }
    stageMs(record_, Stage::pose) += watch.lapMs();
  }
  a.T_cam_world = a.pose.T_cam_world;
  return a;
}

/// Judges an attempt; if good, its features become the frame's and its numbers the record's.
bool Tracker::accept(Attempt& a, int required) {
  const int matched = static_cast<int>(a.reprojected.features.size() + a.segments.segments.size());
  const int inliers = a.pose.inliers + a.pose.segment_inliers;
  // Segments that are followed for their depth only have no say in the pose, so none in its
  // failure.
  const auto& segments = a.segments.segments;
  const int followed = static_cast<int>(std::count_if(
      segments.begin(), segments.end(), [](const TrackedSegment& s) { return !s.informs; }));
  const int informing = matched - followed;
  const int equations = a.pose.ok ? equationsOf(a.pose, a.reprojected.features) : 0;
  record_.align_rmse = a.aligned.rmse;
  record_.gain = a.aligned.gain;
  record_.offset = a.aligned.offset;
  Funnel& funnel = record_.funnel;
  funnel.aligned_sparse = a.aligned.patches;
  funnel.candidates = a.reprojected.candidates + a.segments.candidates;
  funnel.projected = a.reprojected.projected + a.segments.projected;
  funnel.tried = a.reprojected.tried + a.segments.tried;
  funnel.matched = matched;
  funnel.inliers = inliers;
  funnel.required = required;
  failed_features_ = a.reprojected.failed;
  failed_segments_ = a.segments.failed;
  local_keyframes_ = a.reprojected.local_keyframes;
  if (matched < required) {
    a.failure = fmt::format("{} features matched of {} tried, {} required", matched, funnel.tried,
                            required);
  } else if (!a.pose.ok || inliers < required) {
    a.failure = fmt::format("{} inliers of {} matched, {} required", inliers, matched, required);
  } else if (inliers < parameters_.quality.min_inlier_fraction * informing) {
    a.failure = fmt::format("{} inliers are under {:.0f} % of {} matched", inliers,
                            100 * parameters_.quality.min_inlier_fraction, informing);
  } else if (inliers < parameters_.quality.min_tried_fraction * funnel.tried &&
             equations < 2 * required) {
    a.failure = fmt::format("{} inliers with {} equations are under {:.0f} % of {} tried", inliers,
                            equations, 100 * parameters_.quality.min_tried_fraction, funnel.tried);
  }
  if (!a.failure.empty()) return false;
  for (std::size_t i = 0; i < a.reprojected.features.size(); ++i) {
    TrackedFeature& f = a.reprojected.features[i];
    f.error_px = a.pose.error_px[i];
    f.status = a.pose.inlier[i] ? FeatureStatus::inlier : FeatureStatus::outlier;
  }
  frame_.features = a.reprojected.features;
  frame_.noise_px = a.pose.scale_px;
  constexpr double kNews = 0.05;  // about the last twenty frames
  usual_noise_px_ = usual_noise_px_ > 0 ? (1 - kNews) * usual_noise_px_ + kNews * a.pose.scale_px
                                        : a.pose.scale_px;
  acceptSegments(a);
  occupied_ = a.reprojected.occupied;
  countTries();
  return true;
}

/// At a wrong pose chance alone matches some of hundreds: a share of what was tried must fit too,
/// and it must fit as well as usual.
bool Tracker::acceptRelocalization(Attempt& a) {
  const QualityParameters& q = parameters_.quality;
  const int tried = a.reprojected.tried + a.segments.tried;
  constexpr double kLeastNoisePx = 0.1;  // far below it, the image is rendered or does not move
  const double most = q.relocalized_noise * std::max(usual_noise_px_, kLeastNoisePx);
  if (usual_noise_px_ > 0 && a.pose.scale_px > most) {
    a.failure = fmt::format("errors of {:.2f} px, {:.2f} px allowed", a.pose.scale_px, most);
    return false;
  }
  return accept(a,
                std::max(q.relocalized_inliers, static_cast<int>(q.relocalized_fraction * tried)));
}

/// Only frames with a pose count: while lost, the map is not to blame for what it does not match.
void Tracker::countTries() {
  const auto count = [](auto& landmark, bool good, int max_failures) {
    ++(good ? landmark.succeeded : landmark.failed);
    return landmark.failed <= max_failures || landmark.failed <= landmark.succeeded / 4;
  };
  const auto countPoint = [&](const TrackedFeature& f) {
    Landmark* landmark = f.origin == FeatureOrigin::landmark ? map_.find(f.id) : nullptr;
    const bool keep = !landmark || count(*landmark, f.status == FeatureStatus::inlier,
                                         parameters_.reproject.max_failures);
    if (!keep) map_.removeLandmark(f.id);
  };
  const auto countSegment = [&](const TrackedSegment& s) {
    const auto it =
        s.origin == FeatureOrigin::landmark ? map_.segments.find(s.id) : map_.segments.end();
    const bool keep =
        it == map_.segments.end() || count(it->second, s.status == FeatureStatus::inlier,
                                           parameters_.mapping.segments.max_failures);
    if (!keep) map_.removeSegment(s.id);
  };
  for (const auto* features : {&frame_.features, &failed_features_}) {
    for (const TrackedFeature& f : *features) countPoint(f);
  }
  for (const auto* segments : {&frame_.segments, &failed_segments_}) {
    for (const TrackedSegment& s : *segments) countSegment(s);
  }
}

}  // namespace svoscope
