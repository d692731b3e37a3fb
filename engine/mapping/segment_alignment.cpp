// SPDX-License-Identifier: MIT
#include "engine/mapping/segment_alignment.h"

#include <algorithm>
#include <cmath>

namespace svoscope {

namespace {

constexpr double kBorder = 8;     // px: predicted samples keep this far inside the image
constexpr int kLeastSamples = 3;  // two always fit

struct Place {
  Vec2 px_ref;  ///< on the reference line, level 0
  Vec2 px;      ///< predicted, level 0
  Vec3 f_ref;
  double distance;  ///< from the reference camera
};

/// The point at parameter t in both views; false where one of them does not see it.
bool placeAt(const SegmentQuery& q, const ImageLine& line_ref, double t, Place& out) {
  const Vec3 p_ref = (1 - t) * q.p_ref[0] + t * q.p_ref[1];
  const Vec3 p_cur = q.T_cur_ref * p_ref;
  if (p_ref.z() < 1e-3 || p_cur.z() < 1e-3) return false;
  out.px = q.camera.project(p_cur);
  // What the patch must show is the edge as observed, not as the map believes it.
  out.px_ref = line_ref.closest(q.camera.project(p_ref));
  out.f_ref = q.camera.bearing(out.px_ref);
  out.distance = p_ref.norm();
  return q.camera.inside(out.px_ref, kBorder) && q.camera.inside(out.px, kBorder);
}

struct Sampler {
  const SegmentQuery& q;
  const SegmentParameters& p;
  const FeatureAlignmentParameters& alignment;
  ImageLine line_ref, line;  ///< `line`: predicted in the current view

  /// Offset across the predicted line, level-0 px; false if the alignment failed.
  bool measure(double t, int level, LineSample& sample) const {
    Place place;
    if (!placeAt(q, line_ref, t, place)) return false;
    const Mat2 A = affineWarp(q.camera, q.T_cur_ref, place.f_ref, place.distance);
    WarpedPatch patch;
    if (!warpPatch((*q.ref)[q.anchor.level], place.px_ref, q.anchor.level, A, level, patch))
      return false;
    const AlignmentResult r =
        alignPatch1D((*q.cur)[level], patch, toLevel(place.px, level), line.normal, alignment);
    if (!r.converged || (r.px - toLevel(place.px, level)).norm() > p.max_shift_px) return false;
    const Vec2 along(line.normal.y(), -line.normal.x());
    sample.s = along.dot(place.px);
    sample.offset = line.distance(fromLevel(r.px, level));
    return true;
  }
};

/// Pyramid level of the current view at which the middle of the segment has the reference's size.
int levelOf(const SegmentQuery& q, const ImageLine& line_ref, double t) {
  Place place;
  if (!placeAt(q, line_ref, t, place)) return q.anchor.level;
  const Mat2 A = affineWarp(q.camera, q.T_cur_ref, place.f_ref, place.distance);
  return searchLevel(A, q.anchor.level, static_cast<int>(q.cur->size()) - 1);
}

}  // namespace

LineFit fitLine(const std::vector<LineSample>& samples, double inlier) {
  LineFit best;
  const auto residual = [](const LineSample& s, double a, double b) {
    return std::abs(s.offset - a - b * s.s) * std::sqrt(s.weight);
  };
  double best_cost = 1e300;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    for (std::size_t j = i + 1; j < samples.size(); ++j) {
      const double ds = samples[j].s - samples[i].s;
      if (std::abs(ds) < 1e-12) continue;
      const double b = (samples[j].offset - samples[i].offset) / ds,
                   a = samples[i].offset - b * samples[i].s;
      double cost = 0;
      for (const LineSample& s : samples)
        cost += std::min(std::pow(residual(s, a, b), 2), inlier * inlier);
      if (cost < best_cost) best_cost = cost, best.a = a, best.b = b;
    }
  }
  Mat2 H = Mat2::Zero();
  Vec2 g = Vec2::Zero();
  std::vector<const LineSample*> kept;
  for (const LineSample& s : samples) {
    if (residual(s, best.a, best.b) > inlier) continue;
    kept.push_back(&s);
    H += s.weight * Vec2(1, s.s) * Vec2(1, s.s).transpose();
    g += s.weight * s.offset * Vec2(1, s.s);
  }
  best.inliers = static_cast<int>(kept.size());
  const double det = H(0, 0) * H(1, 1) - H(0, 1) * H(1, 0);
  if (kept.size() < 2 || !(std::abs(det) > 1e-12 * H(0, 0) * H(1, 1))) return best;
  best.a = (H(1, 1) * g[0] - H(0, 1) * g[1]) / det;
  best.b = (H(0, 0) * g[1] - H(1, 0) * g[0]) / det;
  for (const LineSample* s : kept) best.rms += std::pow(s->offset - best.a - best.b * s->s, 2);
  best.rms = std::sqrt(best.rms / static_cast<double>(kept.size()));
  return best;
}

SegmentAlignment alignSegment(const SegmentQuery& q, const SegmentParameters& p,
                              const FeatureAlignmentParameters& alignment) {
  SegmentAlignment out;
  const Vec3 p0 = q.T_cur_ref * q.p_ref[0], p1 = q.T_cur_ref * q.p_ref[1];
  if (!clipToImage(q.camera, p0, p1, kBorder + 1, out.t[0], out.t[1])) return out;
  for (int i = 0; i < 2; ++i)
    out.predicted[i] = q.camera.project(Vec3((1 - out.t[i]) * p0 + out.t[i] * p1));
  const double length = (out.predicted[1] - out.predicted[0]).norm();
  const Sampler sampler{q, p, alignment, lineThrough(q.anchor.px[0], q.anchor.px[1]),
                        lineThrough(out.predicted[0], out.predicted[1])};
  out.level = levelOf(q, sampler.line_ref, 0.5 * (out.t[0] + out.t[1]));
  const int wanted =
      std::min(p.max_samples, static_cast<int>(length / (p.sample_spacing_px * (1 << out.level))));
  if (wanted < kLeastSamples) return out;
  std::vector<LineSample> samples;
  // Equal steps in the image: the parameter runs with 1/z.
  const double z0 = 1 / ((1 - out.t[0]) * p0 + out.t[0] * p1).z(),
               z1 = 1 / ((1 - out.t[1]) * p0 + out.t[1] * p1).z();
  for (int i = 0; i < wanted; ++i) {
    const double u = (i + 0.5) / wanted, w0 = (1 - u) * z0, w1 = u * z1;
    LineSample sample;
    ++out.samples;
    // An offset holds across the search level's pixels.
    if (sampler.measure((w0 * out.t[0] + w1 * out.t[1]) / (w0 + w1), out.level, sample))
      samples.push_back(sample);
    const int left = wanted - i - 1;
    if (static_cast<int>(samples.size()) + left < kLeastSamples) return out;
  }
  const LineFit fit = fitLine(samples, p.fit_inlier_px * (1 << out.level));
  out.inliers = fit.inliers;
  out.rms_px = fit.rms;
  if (fit.inliers < kLeastSamples || fit.inliers * 10 < wanted * 6) return out;
  const Vec2 along(sampler.line.normal.y(), -sampler.line.normal.x());
  for (int i = 0; i < 2; ++i)
    out.px[i] =
        out.predicted[i] + (fit.a + fit.b * along.dot(out.predicted[i])) * sampler.line.normal;
  out.ok = true;
  return out;
}

}  // namespace svoscope
