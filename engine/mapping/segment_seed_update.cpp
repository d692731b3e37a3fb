// SPDX-License-Identifier: MIT
#include "engine/mapping/segment_seed_update.h"

#include <algorithm>
#include <cmath>

#include "engine/mapping/segment_alignment.h"

namespace svoscope {

namespace {

/// One search between the end points.
struct Vote {
  double u = 0;  ///< 0 .. 1 along the segment in the image
  double inv_z = 0, tau_z = 0;
};

EpipolarMatch searchAt(const SegmentSearch& s, double u, const MappingParameters& p, Vec3& f) {
  EpipolarQuery q;
  q.ref = s.ref;
  q.cur = s.cur;
  q.camera = s.camera;
  q.T_cur_ref = s.T_cur_ref;
  q.px_ref = (1 - u) * s.anchor.px[0] + u * s.anchor.px[1];
  q.f_ref = f = s.camera.bearing(q.px_ref);
  q.level_ref = s.anchor.level;
  q.type = FeatureType::edgelet;
  q.gradient_dir = lineThrough(s.anchor.px[0], s.anchor.px[1]).normal;
  const auto between = [&](const double(&v)[2]) {
    return f.z() * ((1 - u) * v[0] / s.anchor.f[0].z() + u * v[1] / s.anchor.f[1].z());
  };
  q.mu = between(s.mu);
  q.sigma = between(s.sigma);
  EpipolarParameters search = p.search;
  search.min_edge_cosine = p.segments.min_edge_cosine;
  return searchEpipolar(q, search, p.alignment);
}

/// Angle between the epipolar direction at the match and the segment's normal there.
double epipolarCosine(const SegmentSearch& s, const EpipolarMatch& match, const Vec3& f) {
  const Vec3 q = s.T_cur_ref.quaternion() * f + match.inv_distance * s.T_cur_ref.translation();
  const Vec2 along = s.camera.projectJacobian(q) * s.T_cur_ref.translation();
  return std::abs(match.gradient_dir.dot(along.normalized()));
}

/// The reason to keep when the votes do not make a measurement.
SearchOutcome reasonOf(const std::vector<SearchOutcome>& outcomes) {
  const auto half = static_cast<std::ptrdiff_t>(outcomes.size() + 1) / 2;
  for (const SearchOutcome o :
       {SearchOutcome::edge_parallel, SearchOutcome::out_of_view, SearchOutcome::low_parallax}) {
    if (std::count(outcomes.begin(), outcomes.end(), o) >= half) return o;
  }
  return SearchOutcome::no_match;
}

/// Line through the votes; fills x and tau of both end points. False if too few agree.
bool fitVotes(const std::vector<Vote>& votes, const SegmentAnchor& anchor, SegmentMeasurement& m) {
  constexpr double kAgree = 3;  // sigmas
  std::vector<LineSample> samples;
  for (const Vote& v : votes) samples.push_back({v.u, v.inv_z, 1 / (v.tau_z * v.tau_z)});
  const LineFit fit = fitLine(samples, kAgree);
  if (fit.inliers < 3 || fit.inliers * 10 < static_cast<int>(votes.size()) * 6) return false;
  Mat2 H = Mat2::Zero();
  double lo = 1, hi = 0;
  int used = 0;
  for (const LineSample& s : samples) {
    if (std::abs(s.offset - fit.a - fit.b * s.s) * std::sqrt(s.weight) > kAgree) continue;
    H += s.weight * Vec2(1 - s.s, s.s) * Vec2(1 - s.s, s.s).transpose();
    lo = std::min(lo, s.s);
    hi = std::max(hi, s.s);
    ++used;
  }
  if (hi - lo < 0.35 || used < 3) return false;
  // Errors along one edge are alike (same texture, same pose error): as if only two had been made.
  const Mat2 C = H.inverse() * (used / 2.0);
  for (int i = 0; i < 2; ++i) {
    m.x[i] = (fit.a + i * fit.b) * anchor.f[i].z();
    m.tau[i] = std::sqrt(C(i, i)) * anchor.f[i].z();
    if (!(m.x[i] > 0) || !std::isfinite(m.tau[i])) return false;
  }
  return true;
}

}  // namespace

SegmentAnchor makeSegmentAnchor(const Vec2& a, const Vec2& b, const Pinhole& camera, int level) {
  SegmentAnchor anchor;
  anchor.px[0] = a;
  anchor.px[1] = b;
  for (int i = 0; i < 2; ++i) anchor.f[i] = camera.bearing(anchor.px[i]);
  anchor.level = level;
  return anchor;
}

SegmentSeed makeSegmentSeed(const SegmentAnchor& anchor, double median_depth, double min_depth,
                            const DepthFilterParameters& p) {
  SegmentSeed seed;
  seed.anchor = anchor;
  seed.range = 1.0 / (0.5 * min_depth);
  for (Belief& belief : seed.belief) {
    belief.mu = 1.0 / median_depth;
    belief.sigma2 = std::pow(seed.range * p.initial_sigma_fraction, 2);
    belief.a = belief.b = p.initial_ab;
  }
  return seed;
}

SegmentMeasurement searchSegment(const SegmentSearch& s, const MappingParameters& p) {
  SegmentMeasurement m;
  std::vector<Vote> votes;
  std::vector<SearchOutcome> outcomes;
  const int n = std::max(p.segments.search_samples, 3);
  for (int i = 0; i < n; ++i) {
    // Not at the very ends: there half of the patch shows no edge.
    const double u = 0.06 + 0.88 * i / (n - 1);
    Vec3 f;
    const EpipolarMatch match = searchAt(s, u, p, f);
    outcomes.push_back(match.outcome);
    if (match.outcome != SearchOutcome::matched) continue;
    const double cosine = std::max(epipolarCosine(s, match, f), 0.1);
    votes.push_back({u, match.inv_distance / f.z(), match.tau / cosine / f.z()});
  }
  m.outcome = fitVotes(votes, s.anchor, m) ? SearchOutcome::matched : reasonOf(outcomes);
  return m;
}

SegmentMeasurement measureFromLine(const Pinhole& camera, const SE3& T_cur_ref,
                                   const SegmentAnchor& anchor, const Vec2 (&px)[2],
                                   const MappingParameters& p) {
  SegmentMeasurement m;
  m.outcome = SearchOutcome::tracked;
  const ImageLine line = lineThrough(px[0], px[1]);
  for (int i = 0; i < 2; ++i) {
    const RayLineIntersection r = intersectRayLine(camera, T_cur_ref, anchor.f[i], line);
    if (r.cosine < p.segments.min_edge_cosine) return m.outcome = SearchOutcome::edge_parallel, m;
    if (!(r.inv_distance > 0)) return m.outcome = SearchOutcome::no_match, m;
    const Vec3 q = T_cur_ref.quaternion() * anchor.f[i] + r.inv_distance * T_cur_ref.translation();
    m.x[i] = r.inv_distance;
    m.tau[i] =
        p.search.pixel_noise * r.per_px * std::sqrt(lineVariance(px[0], px[1], camera.project(q)));
  }
  return m;
}

void applySegmentMeasurement(SegmentSeed& seed, const SegmentMeasurement& m,
                             const DepthFilterParameters& p) {
  switch (noteSearch(seed, m.outcome, m.frame_index)) {
    case Evidence::measured: {
      double a = 0, b = 0;
      for (int i = 0; i < 2; ++i) {
        seed.belief[i] = updateBelief(p.rule, seed.belief[i],
                                      {m.x[i], m.tau[i] * m.tau[i], seed.range}, p.rules);
        a += 0.5 * seed.belief[i].a;
        b += 0.5 * seed.belief[i].b;
        seed.last_x[i] = m.x[i];
        seed.last_tau[i] = m.tau[i];
      }
      // Both ends were found by one search: one vote on whether it was right.
      for (Belief& belief : seed.belief) belief.a = a, belief.b = b;
      break;
    }
    case Evidence::missed:
      for (Belief& belief : seed.belief) belief.b += 1;
      break;
    case Evidence::none:
      return;
  }
  judge(seed, seed.belief, 2, p);
}

SegmentJobResult runSegmentJob(const MappingJob& job, const MappingParameters& p) {
  SegmentJobResult result;
  if (!p.segments.enabled) return result;
  for (const JobSegmentSeed& seed : job.segments.seeds) {
    const JobKeyframe& owner = job.keyframes[static_cast<std::size_t>(seed.keyframe_slot)];
    SegmentSearch s{owner.pyramid.get(),
                    job.pyramid.get(),
                    job.camera,
                    job.T_cam_world * owner.T_cam_world.inverse(),
                    seed.anchor,
                    {seed.mu[0], seed.mu[1]},
                    {seed.sigma[0], seed.sigma[1]}};
    SegmentMeasurement m = searchSegment(s, p);
    m.seed_id = seed.id;
    m.keyframe_id = owner.id;
    m.frame_index = job.frame_index;
    result.measurements.push_back(m);
  }
  if (!job.new_seeds.wanted) return result;
  const int level = std::min<int>(p.segments.level, static_cast<int>(job.pyramid->size()) - 1);
  for (const DetectedSegment& d :
       detectSegments(*job.pyramid, p.segments.detector, job.segments.tracked)) {
    NewSegmentSeed fresh{makeSegmentAnchor(d.px[0], d.px[1], job.camera, level), {}};
    SegmentSeed seed = makeSegmentSeed(fresh.anchor, job.new_seeds.median_depth,
                                       job.new_seeds.min_depth, p.filter);
    for (const JobKeyframe& view : job.older_views) {
      SegmentSearch s{job.pyramid.get(),
                      view.pyramid.get(),
                      job.camera,
                      view.T_cam_world * job.T_cam_world.inverse(),
                      fresh.anchor,
                      {},
                      {}};
      for (int i = 0; i < 2; ++i)
        s.mu[i] = seed.belief[i].mu, s.sigma[i] = std::sqrt(seed.belief[i].sigma2);
      SegmentMeasurement m = searchSegment(s, p);
      if (m.outcome != SearchOutcome::matched) continue;
      m.keyframe_id = job.new_seeds.keyframe_id;
      m.frame_index = job.frame_index;
      applySegmentMeasurement(seed, m, p.filter);
      fresh.measurements.push_back(m);
    }
    result.new_seeds.push_back(std::move(fresh));
  }
  return result;
}

}  // namespace svoscope
