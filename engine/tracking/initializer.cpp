// SPDX-License-Identifier: MIT
#include "engine/tracking/initializer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/quantile.h"
#include "engine/tracking/initializer_solve.h"

namespace svoscope {

namespace {

/// Attempts cost ten times as much as tracking: the further off the last one was, the longer the
/// next can wait. Depth uncertainty falls about as fast as the baseline grows.
int framesToWait(const StartSolution& solution, const InitializerParameters& parameters) {
  if (solution.verdict != TwoViewVerdict::low_parallax || !(solution.depth_sigma > 0)) return 3;
  const double ratio = solution.depth_sigma / parameters.max_depth_sigma;
  return 1 + static_cast<int>(std::clamp(2 * (ratio - 1), 0.0, 5.0));
}

void fillSuccess(const InitializerReference& reference, const StartSolution& solution,
                 const Pinhole& camera, InitializerOutput& out) {
  out.initialized = true;
  out.T_cur_ref = solution.T_frame_ref.back();
  out.reference_timestamp = reference.timestamp();
  out.reference_pyramid = reference.pyramid();
  out.poses.push_back({reference.index(), reference.timestamp(), SE3()});
  for (std::size_t k = 0; k < reference.frames().size(); ++k)
    out.poses.push_back(
        {reference.frames()[k].index, reference.frames()[k].timestamp, solution.T_frame_ref[k]});
  for (const StartPoint& point : solution.points) {
    if (!(point.inv_depth > 1e-3)) continue;  // as good as infinitely far: no point to hold on to
    const StartTrack& track = reference.tracks()[point.track];
    InitializerPoint p;
    p.px_ref = track.feature.px;
    p.level = track.feature.level;
    p.type = track.feature.type;
    p.gradient_dir = track.feature.gradient_dir;
    p.p_ref = camera.unproject(p.px_ref) / point.inv_depth;
    p.px_cur = p.type == FeatureType::edgelet ? camera.project(out.T_cur_ref * p.p_ref) : track.px;
    p.sigma_inv_depth = point.sigma_inv_depth;
    p.residual_px = point.residual_px;
    out.points.push_back(p);
  }
}

}  // namespace

Initializer::Initializer(const Pinhole& camera, const InitializerParameters& parameters)
    : camera_(camera), parameters_(parameters) {
  if (!(parameters_.min_disparity_px > 0)) parameters_.min_disparity_px = 0.015 * camera.width;
}

void Initializer::reset() { references_.clear(); }

InitializerOutput Initializer::process(const InitializerFrame& frame) {
  for (auto& reference : references_) reference->track(frame);
  InitializerOutput out;
  // Oldest first: it has the longest baseline.
  for (auto& reference : references_) {
    if (frame.index < reference->next_attempt_index || !dueForAttempt(*reference)) continue;
    const StartSolution solution = solveStart(*reference, camera_, parameters_);
    out.verdict = solution.verdict;
    out.model = solution.model;
    out.reason = solution.reason;
    out.reference_index = reference->index();
    out.tracks_alive = reference->alive();
    out.disparity_px = reference->disparity();
    out.inliers = static_cast<int>(solution.points.size());
    out.rms_px = solution.rms_px;
    out.parallax_deg = solution.parallax_deg;
    out.depth_sigma = solution.depth_sigma;
    if (solution.verdict == TwoViewVerdict::ok) {
      fillSuccess(*reference, solution, camera_, out);
      reset();
      return out;
    }
    reference->last_attempt_px = reference->disparity();
    reference->next_attempt_index = frame.index + framesToWait(solution, parameters_);
    reference->hints.clear();
    if (solution.T_cur_ref.translation().norm() > 0.5) reference->hints = {solution.T_cur_ref};
    break;  // one attempt per frame
  }
  renewReferences(frame);
  fillTracks(out);
  return out;
}

bool Initializer::dueForAttempt(const InitializerReference& reference) const {
  if (reference.alive() < parameters_.min_tracks ||
      static_cast<int>(reference.frames().size()) < parameters_.min_frames)
    return false;
  if (reference.disparity() < parameters_.min_disparity_px) return false;
  // Attempts cost tens of milliseconds: after a failure wait for a visible change.
  const double change = std::abs(reference.disparity() - reference.last_attempt_px);
  return change > std::max(1.5, 0.05 * reference.last_attempt_px);
}

void Initializer::renewReferences(const InitializerFrame& frame) {
  const auto spent = [&](const std::unique_ptr<InitializerReference>& r) {
    return r->alive() < parameters_.min_tracks || r->aliveRatio() < parameters_.min_track_ratio ||
           static_cast<int>(r->frames().size()) > parameters_.max_age;
  };
  references_.erase(std::remove_if(references_.begin(), references_.end(), spent),
                    references_.end());
  const bool wanted = references_.empty() ||
                      references_.back()->aliveRatio() < parameters_.renew_track_ratio ||
                      references_.back()->disparity() > 2 * parameters_.min_disparity_px;
  if (!wanted) return;
  auto fresh = std::make_unique<InitializerReference>(frame, parameters_, next_id_);
  if (fresh->alive() < parameters_.min_tracks && !references_.empty()) return;
  next_id_ += fresh->alive();
  references_.push_back(std::move(fresh));
  if (static_cast<int>(references_.size()) > parameters_.max_references) references_.pop_front();
}

void Initializer::fillTracks(InitializerOutput& out) const {
  if (references_.empty()) return;
  const InitializerReference& shown = *references_.front();
  out.reference_index = shown.index();
  out.tracks_alive = shown.alive();
  out.disparity_px = shown.disparity();
  for (const StartTrack& t : shown.tracks())
    if (t.alive) out.tracks.push_back({t.id, t.feature.type, t.feature.px, t.px});
  if (!out.reason.empty()) return;
  if (shown.alive() < parameters_.min_tracks)
    out.reason = fmt::format("{} features < {}", shown.alive(), parameters_.min_tracks);
  else
    out.reason = fmt::format("{} tracks, median disparity {:.1f} px < {:.1f} px", shown.alive(),
                             shown.disparity(), parameters_.min_disparity_px);
}

}  // namespace svoscope
