// SPDX-License-Identifier: MIT
#include "engine/tracking/reprojector.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_set>

#include "engine/base/angle.h"

namespace svoscope {

namespace {

constexpr double kBorderPx = 8;

enum class Pass { landmark, converged, unconverged };

struct Candidate {
  Pass pass = Pass::landmark;
  const Landmark* landmark = nullptr;
  const Seed* seed = nullptr;
  Vec2 px = Vec2::Zero();
  Vec3 p_world = Vec3::Zero();
  int rank = 0;  ///< successes minus failures
  double score = 0;
  bool edgelet = false;
};

bool before(const Candidate& a, const Candidate& b) {
  const auto id = [](const Candidate& c) { return c.landmark ? c.landmark->id : c.seed->id; };
  return std::make_tuple(a.pass, a.edgelet, -a.rank, -a.score, id(a)) <
         std::make_tuple(b.pass, b.edgelet, -b.rank, -b.score, id(b));
}

bool projectInside(const Pinhole& camera, const SE3& T_cam_world, const Vec3& p_world, Vec2& px) {
  const Vec3 p = T_cam_world * p_world;
  if (p.z() < 1e-3) return false;
  px = camera.project(p);
  return camera.inside(px, kBorderPx);
}

class Reprojection {
 public:
  Reprojection(const Map& map, const Frame& frame, const ReprojectorParameters& p,
               const MappingParameters& m)
      : map_(map),
        frame_(frame),
        p_(p),
        mapping_(m),
        c_world_(frame.T_cam_world.inverse().translation()) {
    out_.occupied =
        OccupancyGrid(map.camera.width, map.camera.height, scaledCell(p.cell_px, map.camera.width));
  }

  ReprojectionResult run() {
    out_.local_keyframes = overlappingKeyframes(map_, frame_.T_cam_world, p_.local_keyframes);
    collect();
    std::sort(candidates_.begin(), candidates_.end(), before);
    out_.projected = static_cast<int>(candidates_.size());
    for (Candidate& c : candidates_) {
      const int cell = out_.occupied.cellOf(c.px);
      if (out_.occupied.taken(cell)) continue;
      if (static_cast<int>(out_.features.size()) >= p_.max_features || out_.tried >= p_.max_tries) {
        out_.occupied.take(c.px);  // full: no new seeds where candidates wait
        continue;
      }
      ++out_.tried;
      if (tryCandidate(c)) out_.occupied.take(out_.features.back().anchor.px);
    }
    return std::move(out_);
  }

 private:
  void collect() {
    std::unordered_set<std::int64_t> seen;
    for (const int id : out_.local_keyframes) {
      const Keyframe& keyframe = *map_.findKeyframe(id);
      for (const std::int64_t landmark_id : keyframe.landmarks) {
        if (seen.insert(landmark_id).second) addLandmark(*map_.find(landmark_id));
      }
      for (const Seed& seed : keyframe.seeds) addSeed(seed, keyframe);
    }
  }

  void addLandmark(const Landmark& landmark) {
    ++out_.candidates;
    Candidate c;
    if (!projectInside(map_.camera, frame_.T_cam_world, landmark.p_world, c.px)) return;
    c.landmark = &landmark;
    c.p_world = landmark.p_world;
    c.rank = landmark.succeeded - landmark.failed;
    c.score = landmark.score;
    c.edgelet = landmark.type == FeatureType::edgelet;
    candidates_.push_back(c);
  }

  void addSeed(const Seed& seed, const Keyframe& keyframe) {
    const bool converged = seed.status == SeedStatus::converged;
    if (!converged && (seed.status != SeedStatus::active || !p_.unconverged_seeds)) return;
    ++out_.candidates;
    Candidate c;
    c.p_world = seedPoint(seed, keyframe);
    if (!projectInside(map_.camera, frame_.T_cam_world, c.p_world, c.px)) return;
    c.pass = converged ? Pass::converged : Pass::unconverged;
    c.seed = &seed;
    c.score = seed.score;
    c.edgelet = seed.anchor.type == FeatureType::edgelet;
    candidates_.push_back(c);
  }

  bool tryCandidate(Candidate& c) {
    TrackedFeature f;
    f.predicted_px = c.px;
    f.p_world = f.p_believed = c.p_world;
    bool ok = false;
    if (c.landmark) {
      f.origin = FeatureOrigin::landmark;
      f.id = c.landmark->id;
      ok = alignLandmark(*c.landmark, f);
    } else {
      f.id = c.seed->id;
      f.keyframe_id = c.seed->keyframe_id;
      f.depth_px = depthPx(*c.seed);
      f.origin = c.pass == Pass::converged ? FeatureOrigin::converged_seed
                                           : FeatureOrigin::unconverged_seed;
      ok = c.pass == Pass::converged ? alignSeed(*c.seed, f) : searchSeed(*c.seed, f);
    }
    if (!ok) f.status = FeatureStatus::not_aligned;
    (ok ? out_.features : out_.failed).push_back(f);
    return ok;
  }

  /// How far one sigma of a seed's inverse distance moves its projection, to first order.
  Vec2 depthPx(const Seed& seed) const {
    const SE3 T_cur_ref =
        frame_.T_cam_world * map_.findKeyframe(seed.keyframe_id)->T_cam_world.inverse();
    // The point times its inverse distance projects to the same pixel and is linear in it.
    const Vec3 q = T_cur_ref.rotation() * seed.anchor.f + seed.belief.mu * T_cur_ref.translation();
    return map_.camera.projectJacobian(q) * T_cur_ref.translation() * std::sqrt(seed.belief.sigma2);
  }

  bool alignLandmark(const Landmark& landmark, TrackedFeature& f) {
    const LandmarkObservation* view =
        closestView(map_, landmark, c_world_, std::cos(p_.max_view_angle_deg * kDegree));
    if (!view) return false;
    const Keyframe& keyframe = *map_.findKeyframe(view->keyframe_id);
    f.keyframe_id = keyframe.id;
    const double distance = (keyframe.T_cam_world * landmark.p_world).norm();
    return alignAnchor(keyframe, view->anchor, distance, f);
  }

  bool alignSeed(const Seed& seed, TrackedFeature& f) {
    const Keyframe& keyframe = *map_.findKeyframe(seed.keyframe_id);
    const bool ok = alignAnchor(keyframe, seed.anchor, 1.0 / seed.belief.mu, f);
    out_.seed_matches.push_back({ok ? static_cast<int>(out_.features.size()) : -1, seed.id,
                                 keyframe.id,
                                 ok ? SearchOutcome::tracked : SearchOutcome::no_match});
    return ok;
  }

  /// Warps the patch of a reference view at known distance and aligns it at the prediction.
  bool alignAnchor(const Keyframe& keyframe, const FeatureAnchor& anchor, double distance,
                   TrackedFeature& f) {
    const SE3 T_cur_ref = frame_.T_cam_world * keyframe.T_cam_world.inverse();
    const Mat2 A = affineWarp(map_.camera, T_cur_ref, anchor.f, distance);
    const int top = static_cast<int>(frame_.pyramid->size()) - 1;
    const int level = std::min(top, searchLevel(A, anchor.level, top) + p_.coarser);
    WarpedPatch patch;
    if (!warpPatch((*keyframe.pyramid)[anchor.level], anchor.px, anchor.level, A, level, patch))
      return false;
    const Vec2 start = toLevel(f.predicted_px, level);
    const cv::Mat& image = (*frame_.pyramid)[level];
    AlignmentResult aligned;
    f.anchor.type = anchor.type;
    f.anchor.level = level;
    if (anchor.type == FeatureType::edgelet) {
      f.anchor.gradient_dir = (A.inverse().transpose() * anchor.gradient_dir).normalized();
      aligned = alignPatch1D(image, patch, start, f.anchor.gradient_dir, mapping_.alignment);
    } else {
      aligned = alignPatch2D(image, patch, start, mapping_.alignment);
    }
    if (!aligned.converged || (aligned.px - start).norm() > p_.max_shift_px) return false;
    setMeasured(fromLevel(aligned.px, level), f);
    return true;
  }

  bool searchSeed(const Seed& seed, TrackedFeature& f) {
    const Keyframe& keyframe = *map_.findKeyframe(seed.keyframe_id);
    EpipolarQuery q;
    q.ref = keyframe.pyramid.get();
    q.cur = frame_.pyramid.get();
    q.camera = map_.camera;
    q.T_cur_ref = frame_.T_cam_world * keyframe.T_cam_world.inverse();
    q.px_ref = seed.anchor.px;
    q.f_ref = seed.anchor.f;
    q.level_ref = seed.anchor.level;
    q.type = seed.anchor.type;
    q.gradient_dir = seed.anchor.gradient_dir;
    q.mu = seed.belief.mu;
    q.sigma = std::sqrt(seed.belief.sigma2);
    const EpipolarMatch match = searchEpipolar(q, mapping_.search, mapping_.alignment);
    const double inv_distance = fusedInverseDistance(seed.belief, match.inv_distance, match.tau);
    const bool ok = match.outcome == SearchOutcome::matched && inv_distance > 0;
    out_.seed_matches.push_back({ok ? static_cast<int>(out_.features.size()) : -1, seed.id,
                                 keyframe.id, ok ? SearchOutcome::tracked : match.outcome,
                                 match.score});
    if (!ok) return false;
    f.anchor.type = seed.anchor.type;
    f.anchor.level = match.level;
    f.anchor.gradient_dir = match.gradient_dir;
    setMeasured(match.px, f);
    // The match taken at its word, for the next frame and for the map, under either rule of the
    // filter.
    f.p_world = keyframe.T_cam_world.inverse() * (seed.anchor.f / inv_distance);
    return true;
  }

  void setMeasured(const Vec2& px, TrackedFeature& f) const {
    f.anchor.px = px;
    f.anchor.f = map_.camera.bearing(px);
  }

  const Map& map_;
  const Frame& frame_;
  const ReprojectorParameters& p_;
  const MappingParameters& mapping_;
  Vec3 c_world_;
  std::vector<Candidate> candidates_;
  ReprojectionResult out_;
};

/// A few landmarks stand for the whole view.
bool overlaps(const Map& map, const Keyframe& keyframe, const SE3& T_cam_world) {
  constexpr std::size_t kSamples = 12;
  const auto& ids = keyframe.landmarks;
  Vec2 px;
  const std::size_t step = std::max<std::size_t>(1, ids.size() / kSamples);
  for (std::size_t i = 0; i < ids.size(); i += step) {
    const Landmark* landmark = map.find(ids[i]);
    if (landmark && projectInside(map.camera, T_cam_world, landmark->p_world, px)) return true;
  }
  return false;
}

}  // namespace

double fusedInverseDistance(const Belief& belief, double x, double tau) {
  const double belief_weight = 1 / belief.sigma2, weight = 1 / (tau * tau);
  return (belief.mu * belief_weight + x * weight) / (belief_weight + weight);
}

Vec3 seedPoint(const Seed& seed, const Keyframe& keyframe) {
  return keyframe.T_cam_world.inverse() * (seed.anchor.f / seed.belief.mu);
}

std::vector<int> overlappingKeyframes(const Map& map, const SE3& T_cam_world, int most) {
  std::vector<std::pair<double, int>> near;
  const Vec3 c = T_cam_world.inverse().translation();
  for (const auto& [id, keyframe] : map.keyframes) {
    if (!overlaps(map, keyframe, T_cam_world)) continue;
    near.emplace_back((keyframe.T_cam_world.inverse().translation() - c).norm(), id);
  }
  std::sort(near.begin(), near.end());
  std::vector<int> ids;
  for (const auto& [distance, id] : near) {
    if (static_cast<int>(ids.size()) < most) ids.push_back(id);
  }
  return ids;
}

ReprojectionResult reprojectMap(const Map& map, const Frame& frame,
                                const ReprojectorParameters& parameters,
                                const MappingParameters& mapping) {
  return Reprojection(map, frame, parameters, mapping).run();
}

}  // namespace svoscope
