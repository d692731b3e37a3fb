// SPDX-License-Identifier: MIT
// Features and seeds of the fake snapshots.
#include <algorithm>
#include <cmath>

#include "engine/study/lab.h"
#include "tests/support/fake_world.h"

namespace svoscope {

void FakeWorld::fillTracks(Snapshot& s) const {
  const SE3 now = estimate(s.record.index).inverse(), first = estimate(0).inverse();
  for (std::size_t i = 0; i < room_.size(); i += 3) {
    const Vec3 p = now * room_[i].position, q = first * room_[i].position;
    if (p.z() < 0.3 || q.z() < 0.3) continue;
    FeatureView f;
    f.id = static_cast<std::int64_t>(i);
    f.origin = FeatureOrigin::track;
    f.px = info_.camera.project(p).cast<float>();
    f.predicted_px = info_.camera.project(q).cast<float>();
    if (info_.camera.inside(f.px.cast<double>(), 8)) s.features.push_back(f);
  }
  s.record.disparity_tracks = static_cast<int>(s.features.size());
  s.record.disparity_px = 3.6 * s.record.index;
}

void FakeWorld::fillFeatures(Snapshot& s) const {
  const SE3 T = estimate(s.record.index).inverse();
  Funnel& n = s.record.funnel;
  const bool lost = s.record.state == TrackingState::lost;
  for (std::size_t i = 0; i < room_.size(); i += 2) {
    const Vec3 p = T * room_[i].position;
    ++n.candidates;
    if (p.z() < 0.3) continue;
    const Vec2 px = info_.camera.project(p);
    if (!info_.camera.inside(px, 8)) continue;
    ++n.projected;
    FeatureView f;
    f.id = static_cast<std::int64_t>(1000 + i);
    f.type = room_[i].type;
    f.origin = i % 9 == 0   ? FeatureOrigin::converged_seed
               : i % 7 == 0 ? FeatureOrigin::unconverged_seed
                            : FeatureOrigin::landmark;
    const double luck = fakeNoise(static_cast<int>(i), s.record.index);
    f.status = std::abs(luck) > 1.0 || (lost && i % 8) ? FeatureStatus::not_aligned
               : luck > 0.8                            ? FeatureStatus::outlier
                                                       : FeatureStatus::inlier;
    f.level = static_cast<std::uint8_t>(i % 3);
    f.predicted_px = px.cast<float>();
    const double size = f.status == FeatureStatus::outlier ? 4 : room_[i].noise;
    f.px = f.predicted_px +
           Vec2f(static_cast<float>(size * fakeNoise(static_cast<int>(i), s.record.index + 500)),
                 static_cast<float>(size * fakeNoise(static_cast<int>(i), s.record.index + 900)));
    f.direction = static_cast<float>(room_[i].direction);
    const double a = room_[i].direction + 1.5708, length = 60 / p.z();
    f.px_end = f.px + Vec2f(static_cast<float>(std::cos(a) * length),
                            static_cast<float>(std::sin(a) * length));
    f.depth = static_cast<float>(p.z());
    f.residual_px = (f.px - f.predicted_px).norm();
    f.observations = 2 + static_cast<int>(i % 11);
    f.reference_keyframe =
        std::max(0, (s.record.index - options_.start) / 9 - static_cast<int>(i % 3));
    ++n.tried;
    n.matched += f.status != FeatureStatus::not_aligned;
    n.inliers += f.status == FeatureStatus::inlier;
    n.inlier_seeds += f.status == FeatureStatus::inlier && f.origin != FeatureOrigin::landmark;
    n.inlier_edgelets += f.status == FeatureStatus::inlier && f.type == FeatureType::edgelet;
    n.inlier_segments += f.status == FeatureStatus::inlier && f.type == FeatureType::segment;
    s.features.push_back(f);
  }
  n.inlier_landmarks = n.inliers - n.inlier_seeds;
  n.required = 40;
  n.aligned_sparse = n.matched;
}

namespace {

// Both rules converge on the truth, JS faster.
BeliefView fakeBelief(int i, int updates, double truth, FilterRule rule) {
  const bool js = rule != FilterRule::kl;
  BeliefView b;
  const double sigma = 0.25 / (1 + (js ? 0.8 : 0.6) * updates);
  b.sigma = static_cast<float>(sigma);
  b.mu = static_cast<float>(truth + 0.6 * sigma * fakeNoise(i, js ? 2 : 1));
  b.a = 10 + static_cast<float>(updates) * (js ? 0.85f : 0.8f);
  b.b = 10 + static_cast<float>(updates) * 0.15f;
  return b;
}

SeedUpdateView fakeUpdate(const SeedView& seed, int i, int frame, double truth) {
  SeedUpdateView u;
  u.seed_id = seed.id;
  u.keyframe_id = seed.keyframe_id;
  u.frame_index = frame;
  u.outcome = seed.outcome;
  u.px = seed.px;
  for (const FilterRule rule : kRules)
    u.before[rule] = fakeBelief(i, seed.updates - 1, truth, rule);
  u.after = seed.belief;
  if (u.outcome != SearchOutcome::matched) return u;
  u.score = 120;
  u.x = seed.last_x;
  u.tau = seed.last_tau;
  const LabPair pair =
      comparePair(u.before[FilterRule::kl].mu, u.before[FilterRule::kl].sigma, u.x, u.tau);
  u.kl_belief_measurement = static_cast<float>(pair.kl_pq);
  u.kl_measurement_belief = static_cast<float>(pair.kl_qp);
  u.jsd = static_cast<float>(pair.jsd);
  u.affinity = static_cast<float>(pair.affinity);
  return u;
}

}  // namespace

void FakeWorld::fillSeeds(Snapshot& s) const {
  auto seeds = std::make_shared<std::vector<SeedView>>();
  auto updates = std::make_shared<std::vector<SeedUpdateView>>();
  const SE3 T = estimate(s.record.index).inverse();
  const auto project = [&](const Vec3& world, Vec2f& px) {
    const Vec3 p = T * world;
    if (p.z() < 0.1) return false;
    const Vec2 at = info_.camera.project(p);
    px = at.cast<float>();
    return info_.camera.inside(at, 2);
  };
  for (int i = 0; i < options_.seeds && !room_.empty(); ++i) {
    const std::size_t k = (static_cast<std::size_t>(i) * 2 + 1) % room_.size();
    SeedView v;
    const bool shared = k % 9 == 0 || k % 7 == 0;
    v.id = static_cast<std::int64_t>(shared ? 1000 + k : 5000 + static_cast<std::size_t>(i));
    v.keyframe_id = std::max(0, (s.record.index - options_.start) / 9 - 1);
    v.type = room_[k].type;
    const int age = s.record.index - options_.start - (i % 20) * 9;
    if (age < 0 || (!shared && age > 70)) continue;
    v.updates = std::min(40, age);
    v.failures = i % 5;
    const Vec3 origin = estimate(options_.start).translation();
    const Vec3 ray = room_[k].position - origin;
    const double distance = ray.norm();
    for (const FilterRule rule : kRules)
      v.belief[rule] = fakeBelief(i, v.updates, 1 / distance, rule);
    const double sigma = v.belief[FilterRule::kl].sigma;
    v.sigma = v.belief[FilterRule::kl].sigma;
    v.mu = v.belief[FilterRule::kl].mu;
    v.range = 1.2f;
    v.a = v.belief[FilterRule::kl].a;
    v.b = v.belief[FilterRule::kl].b;
    if (options_.ground_truth) v.true_inv_distance = static_cast<float>(1 / (1.7 * distance));
    v.status = v.updates > 34 ? SeedStatus::converged : SeedStatus::active;
    v.outcome = i % 6 == 0 ? SearchOutcome::no_match : SearchOutcome::matched;
    const auto along = [&](double inverse) {
      return Vec3(origin + ray.normalized() / std::max(0.05, inverse));
    };
    v.position = along(v.mu).cast<float>();
    v.position_near = along(v.mu + sigma).cast<float>();
    v.position_far = along(v.mu - sigma).cast<float>();
    v.visible = project(along(v.mu), v.px);
    project(along(v.mu + sigma), v.px_near);
    project(along(v.mu - sigma), v.px_far);
    v.last_x = static_cast<float>(1 / distance + 0.05 * fakeNoise(i, v.updates + 50));
    v.last_tau = 0.05f;
    v.px_ref = v.px;
    seeds->push_back(v);
    if (age > 0 && age <= 40) updates->push_back(fakeUpdate(v, i, s.record.index, 1 / distance));
  }
  s.seeds = seeds;
  s.seed_updates = updates;
}

}  // namespace svoscope
