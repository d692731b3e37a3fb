// SPDX-License-Identifier: MIT
// Choosing the window of the local bundle adjustment.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "engine/geometry/segment.h"
#include "engine/mapping/local_adjustment.h"

namespace svoscope {

namespace {

/// Keyframe ids with the number of landmarks shared with `keyframe`, most first.
std::vector<int> covisible(const Map& map, const Keyframe& keyframe) {
  std::map<int, int> shared;
  for (const std::int64_t id : keyframe.landmarks) {
    const Landmark* landmark = map.find(id);
    if (!landmark) continue;
    for (const LandmarkObservation& o : landmark->observations) ++shared[o.keyframe_id];
  }
  shared.erase(keyframe.id);
  std::vector<std::pair<int, int>> ranked;  // (-count, -id): newer first among equals
  for (const auto& [id, count] : shared) ranked.emplace_back(-count, -id);
  std::sort(ranked.begin(), ranked.end());
  std::vector<int> ids;
  for (const auto& [count, id] : ranked) ids.push_back(-id);
  return ids;
}

struct Window {
  std::set<int> free, fixed;
  std::vector<std::int64_t> landmarks;
};

Window chooseWindow(const Map& map, const Keyframe& newest, const LocalAdjustmentParameters& p) {
  Window w;
  w.free.insert(newest.id);
  for (const int id : covisible(map, newest)) {
    if (static_cast<int>(w.free.size()) <= p.keyframes) w.free.insert(id);
  }
  std::set<std::int64_t> landmarks;
  for (const int id : w.free) {
    const auto& seen = map.keyframes.at(id).landmarks;
    landmarks.insert(seen.begin(), seen.end());
  }
  std::map<int, int> outside;
  for (const std::int64_t id : landmarks) {
    const Landmark* landmark = map.find(id);
    if (!landmark || landmark->observations.size() < 2) continue;
    w.landmarks.push_back(id);
    for (const LandmarkObservation& o : landmark->observations) {
      if (!w.free.count(o.keyframe_id) && map.keyframes.count(o.keyframe_id))
        ++outside[o.keyframe_id];
    }
  }
  std::vector<std::pair<int, int>> ranked;
  for (const auto& [id, count] : outside) ranked.emplace_back(-count, -id);
  std::sort(ranked.begin(), ranked.end());
  for (const auto& [count, id] : ranked) {
    if (static_cast<int>(w.fixed.size()) < p.fixed_keyframes) w.fixed.insert(-id);
  }
  // Without held keyframes the oldest one of the window holds the frame. The scale is left to the
  // damping of the solver: holding the second pose too would keep the errors of the start for good.
  if (w.fixed.empty() && *w.free.begin() != newest.id) {
    w.fixed.insert(*w.free.begin());
    w.free.erase(w.free.begin());
  }
  return w;
}

using Slots = std::map<int, int>;  ///< keyframe id to index

void addPoints(const Map& map, const Window& window, const Slots& slot,
               AdjustmentProblem& problem) {
  for (const std::int64_t id : window.landmarks) {
    const Landmark& landmark = *map.find(id);
    std::vector<AdjustmentObservation> seen;
    for (const LandmarkObservation& o : landmark.observations) {
      const auto s = slot.find(o.keyframe_id);
      if (s == slot.end()) continue;
      seen.push_back({s->second, static_cast<int>(problem.points.size()), o.anchor.px,
                      o.anchor.level, o.anchor.type, o.anchor.gradient_dir});
    }
    if (seen.size() < 2) continue;
    problem.points.push_back({id, landmark.p_world});
    problem.observations.insert(problem.observations.end(), seen.begin(), seen.end());
  }
}

/// The views of one end point as errors across their lines, and one along the first of them.
void addLineViews(const Map& map, const SegmentLandmark& segment, int end, const Slots& slot,
                  const LocalAdjustmentParameters& adjust, const SegmentParameters& p,
                  AdjustmentProblem& problem) {
  const int index = static_cast<int>(problem.ends.size());
  bool held = false;
  for (const SegmentView& view : segment.views) {
    const auto s = slot.find(view.keyframe_id);
    if (s == slot.end()) continue;
    const Vec3 q = map.keyframes.at(view.keyframe_id).T_cam_world * segment.p_world[end];
    if (q.z() < 1e-2) continue;  // a long segment may reach behind a later camera
    const Vec2 px = map.camera.project(q);
    const Vec2* ends = view.anchor.px;
    const ImageLine line = lineThrough(ends[0], ends[1]);
    const double sigma = p.pose_sigma * p.line_noise_px * (1 << view.anchor.level);
    problem.line_views.push_back({s->second, index, line.closest(px), line.normal,
                                  sigma * std::sqrt(lineVariance(ends[0], ends[1], px)), false});
    if (!held)
      problem.line_views.push_back(
          {s->second, index, px, Vec2(-line.normal.y(), line.normal.x()), sigma, true});
    held = true;
  }
  const SegmentView& first = segment.views.front();
  const auto s = slot.find(first.keyframe_id);
  if (s != slot.end() && segment.prior_sigma[end] > 0)
    problem.depths.push_back(
        {s->second, index, first.anchor.f[end], segment.prior[end],
         std::hypot(segment.prior_sigma[end], adjust.depth_floor * segment.prior[end])});
  problem.ends.push_back({segment.id, end, segment.p_world[end]});
}

void addSegments(const Map& map, const Window& window, const Slots& slot,
                 const LocalAdjustmentParameters& adjust, const SegmentParameters& p,
                 AdjustmentProblem& problem) {
  std::set<std::int64_t> ids;
  for (const int id : window.free) {
    const auto& seen = map.keyframes.at(id).segments;
    ids.insert(seen.begin(), seen.end());
  }
  for (const std::int64_t id : ids) {
    const auto it = map.segments.find(id);
    if (it == map.segments.end()) continue;
    const auto& views = it->second.views;
    const auto known = [&](const SegmentView& v) { return slot.count(v.keyframe_id) > 0; };
    if (std::count_if(views.begin(), views.end(), known) < adjust.segment_views) continue;
    for (int end = 0; end < 2; ++end) addLineViews(map, it->second, end, slot, adjust, p, problem);
  }
}

}  // namespace

AdjustmentProblem localProblem(const Map& map, int newest, const LocalAdjustmentParameters& p,
                               const SegmentParameters& segments) {
  AdjustmentProblem problem;
  problem.camera = map.camera;
  const auto it = map.keyframes.find(newest);
  // The two keyframes of the start were adjusted by the start itself.
  if (it == map.keyframes.end() || map.keyframes.size() < 3) return problem;
  const Window window = chooseWindow(map, it->second, p);
  Slots slot;
  for (const auto& [id, keyframe] : map.keyframes) {
    const bool fixed = window.fixed.count(id) > 0;
    if (!fixed && !window.free.count(id)) continue;
    slot[id] = static_cast<int>(problem.keyframes.size());
    problem.keyframes.push_back({id, keyframe.T_cam_world, fixed});
  }
  addPoints(map, window, slot, problem);
  if (segments.enabled) addSegments(map, window, slot, p, segments, problem);
  return problem;
}

}  // namespace svoscope
