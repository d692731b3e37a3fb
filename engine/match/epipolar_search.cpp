// SPDX-License-Identifier: MIT
#include "engine/match/epipolar_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/angle.h"

namespace svoscope {

namespace {

/// Farthest belief searched: inverse distances below are taken as infinity.
constexpr double kMinInverseDistance = 1e-6;

/// The epipolar line as seen from the current camera, level-0 pixels.
struct Line {
  bool valid = false;
  Vec2 middle, near, far;  ///< at mu, mu + n sigma, mu - n sigma
};

/// Homogeneous: q(z) = R f + z t has the direction of the point at inverse distance z.
bool projectInverse(const EpipolarQuery& q, double z, Vec2& px) {
  const Vec3 p = q.T_cur_ref.quaternion() * q.f_ref + z * q.T_cur_ref.translation();
  if (p.z() < 1e-3) return false;
  px = q.camera.project(p);
  return true;
}

Line epipolarLine(const EpipolarQuery& q, double search_sigmas) {
  Line line;
  const double half = search_sigmas * q.sigma;
  double z_near = q.mu + half;
  const double z_far = std::max(q.mu - half, kMinInverseDistance);
  if (!projectInverse(q, q.mu, line.middle) || !projectInverse(q, z_far, line.far)) return line;
  // The near end may lie behind the camera: pull it back towards the belief.
  for (int i = 0; i < 6 && !projectInverse(q, z_near, line.near); ++i)
    z_near = 0.5 * (z_near + q.mu);
  line.valid = projectInverse(q, z_near, line.near);
  return line;
}

/// 8-bit template with its sums, for zero-mean SSD at integer pixels.
struct ScoreTemplate {
  alignas(32) std::int16_t value[kPatchArea];
  int sum = 0, sum_of_squares = 0;

  explicit ScoreTemplate(const WarpedPatch& patch) {
    for (int i = 0, n = 0; i < kPatchSize; ++i) {
      for (int j = 0; j < kPatchSize; ++j, ++n) {
        value[n] = static_cast<std::int16_t>(std::lround(patch.inner(i, j)));
        sum += value[n];
        sum_of_squares += value[n] * value[n];
      }
    }
  }

  /// Zero-mean SSD per pixel with the image patch whose pixel (4, 4) is (x, y).
  double operator()(const cv::Mat& image, int x, int y) const {
    int s = 0, ss = 0, cross = 0;
    for (int i = 0; i < kPatchSize; ++i) {
      const std::uint8_t* row = image.ptr<std::uint8_t>(y - kPatchHalf + i) + x - kPatchHalf;
      const std::int16_t* t = value + i * kPatchSize;
      for (int j = 0; j < kPatchSize; ++j) {
        const int v = row[j];
        s += v;
        ss += v * v;
        cross += v * t[j];
      }
    }
    const double zmssd = static_cast<double>(ss) - 2.0 * cross + sum_of_squares -
                         static_cast<double>(s - sum) * (s - sum) / kPatchArea;
    return zmssd / kPatchArea;
  }
};

bool insideForScore(const cv::Mat& image, int x, int y) {
  return x >= kPatchHalf && y >= kPatchHalf && x < image.cols - kPatchHalf &&
         y < image.rows - kPatchHalf;
}

/// Calls visit(x, y) with the integer pixels along the line on the search level, alternating
/// outwards from the current estimate.
template <typename Visit>
void walkLine(const Line& line, int level, const EpipolarParameters& p, const Visit& visit) {
  const Vec2 middle = toLevel(line.middle, level);
  const Vec2 ends[2] = {toLevel(line.near, level), toLevel(line.far, level)};
  int budget = p.max_samples;
  Vec2 step[2];
  int samples[2];
  for (int side = 0; side < 2; ++side) {
    const double length = (ends[side] - middle).norm();
    samples[side] = static_cast<int>(std::ceil(length / p.step_px));
    step[side] =
        length > 0 ? Vec2((ends[side] - middle) / std::max(samples[side], 1)) : Vec2::Zero();
  }
  // A short side leaves its share of the budget to the other.
  int share[2] = {std::min(samples[0], budget / 2), std::min(samples[1], budget / 2)};
  share[0] = std::min(samples[0], budget - share[1]);
  share[1] = std::min(samples[1], budget - share[0]);
  Eigen::Vector2i last(-1, -1);
  const auto at = [&](const Vec2& px) {
    const Eigen::Vector2i pixel(static_cast<int>(std::lround(px.x())),
                                static_cast<int>(std::lround(px.y())));
    if (pixel == last) return;
    last = pixel;
    visit(pixel.x(), pixel.y());
  };
  at(middle);
  for (int side = 0; side < 2; ++side) {
    for (int i = 1; i <= share[side]; ++i) at(middle + i * step[side]);
  }
}

struct Best {
  double score = std::numeric_limits<double>::infinity();  ///< no sample lay inside
  Vec2 px = Vec2::Zero();
};

Best scanLine(const cv::Mat& image, const ScoreTemplate& score, const Line& line, int level,
              const EpipolarParameters& p) {
  Best best;
  walkLine(line, level, p, [&](int x, int y) {
    if (!insideForScore(image, x, y)) return;
    const double s = score(image, x, y);
    if (s < best.score) best = {s, Vec2(x, y)};
  });
  return best;
}

/// Warped template and what is needed to search with it.
struct Prepared {
  Line line;
  Mat2 A_cur_ref = Mat2::Identity();
  int level = 0;
  WarpedPatch patch;
};

SearchOutcome prepare(const EpipolarQuery& q, const EpipolarParameters& p, Prepared& out) {
  out.line = epipolarLine(q, p.search_sigmas);
  if (!out.line.valid || !out.line.middle.allFinite()) return SearchOutcome::out_of_view;
  if (!q.camera.inside(out.line.middle, 9)) return SearchOutcome::out_of_view;
  out.A_cur_ref =
      affineWarp(q.camera, q.T_cur_ref, q.f_ref, 1.0 / std::max(q.mu, kMinInverseDistance));
  const int top = static_cast<int>(q.cur->size()) - 1;
  out.level = searchLevel(out.A_cur_ref, q.level_ref, top);
  const bool warped =
      warpPatch((*q.ref)[q.level_ref], q.px_ref, q.level_ref, out.A_cur_ref, out.level, out.patch);
  return warped ? SearchOutcome::matched : SearchOutcome::out_of_view;
}

Vec2 warpedGradient(const Mat2& A_cur_ref, const Vec2& gradient_dir) {
  // A gradient is a covector: it maps with the inverse transpose.
  return (A_cur_ref.inverse().transpose() * gradient_dir).normalized();
}

}  // namespace

double triangulateInverseDistance(const Pinhole& camera, const SE3& T_cur_ref, const Vec3& f_ref,
                                  const Vec2& px_cur) {
  const Vec3 a = T_cur_ref.quaternion() * f_ref;
  const Vec3& t = T_cur_ref.translation();
  const Vec3 m = camera.unproject(px_cur);
  const Vec2 A(m.x() * t.z() - t.x(), m.y() * t.z() - t.y());
  const Vec2 b(a.x() - m.x() * a.z(), a.y() - m.y() * a.z());
  const double n = A.squaredNorm();
  return n > 0 ? A.dot(b) / n : -1.0;
}

double parallaxAt(const SE3& T_cur_ref, const Vec3& f_ref, double inv_distance) {
  const Vec3 f_back = T_cur_ref.quaternion() * f_ref,
             q = f_back + inv_distance * T_cur_ref.translation();
  return std::atan2(f_back.cross(q).norm(), f_back.dot(q));
}

double inverseDistanceSigma(const SE3& T_cur_ref, const Vec3& f_ref, double inv_distance,
                            double pixel_noise, double focal) {
  const double px_angle = 2.0 * std::atan(0.5 * pixel_noise / focal);
  const SE3 T_ref_cur = T_cur_ref.inverse();
  const Vec3& t = T_ref_cur.translation();  // current camera seen from the reference
  const double t_norm = t.norm();
  const double distance = 1.0 / std::max(inv_distance, kMinInverseDistance);
  if (t_norm < 1e-9) return 1e6;
  const Vec3 a = f_ref * distance - t;
  const double beta_sine = a.cross(t).norm() / (t_norm * a.norm());
  // With alpha at the reference and beta at the current camera the law of sines gives the inverse
  // distance sin(alpha + beta) / (|t| sin(beta)). Its derivative by beta has no pole at infinity,
  // where the distance itself has: far points keep a finite, usable sigma.
  return px_angle * a.norm() / (distance * t_norm * std::max(beta_sine, 1e-9));
}

EpipolarMatch searchEpipolar(const EpipolarQuery& q, const EpipolarParameters& p,
                             const FeatureAlignmentParameters& alignment) {
  EpipolarMatch match;
  Prepared s;
  match.outcome = prepare(q, p, s);
  if (match.outcome != SearchOutcome::matched) return match;
  match.level = s.level;
  Vec2 direction = s.line.near - s.line.far;
  double length = direction.norm() / (1 << s.level);
  if (direction.norm() < 1e-6) {
    Vec2 ahead;
    if (!projectInverse(q, q.mu * 1.01, ahead))
      return match.outcome = SearchOutcome::low_parallax, match;
    direction = ahead - s.line.middle;
    length = 0;
    if (direction.norm() < 1e-9) return match.outcome = SearchOutcome::low_parallax, match;
  }
  direction.normalize();
  if (q.type == FeatureType::edgelet) {
    match.gradient_dir = warpedGradient(s.A_cur_ref, q.gradient_dir);
    if (std::abs(match.gradient_dir.dot(direction)) < p.min_edge_cosine)
      return match.outcome = SearchOutcome::edge_parallel, match;
  }
  const cv::Mat& image = (*q.cur)[s.level];
  match.outcome = SearchOutcome::no_match;
  Vec2 start = 0.5 * (toLevel(s.line.near, s.level) + toLevel(s.line.far, s.level));
  if (length >= p.short_line_px) {
    const Best best = scanLine(image, ScoreTemplate(s.patch), s.line, s.level, p);
    if (!std::isfinite(best.score)) return match.outcome = SearchOutcome::out_of_view, match;
    match.score = best.score;
    if (best.score > p.max_score) return match;
    start = best.px;
  }
  const AlignmentResult aligned = q.type == FeatureType::edgelet
                                      ? alignPatch1D(image, s.patch, start, direction, alignment)
                                      : alignPatch2D(image, s.patch, start, alignment);
  if (!aligned.converged || (aligned.px - start).norm() > 8) return match;
  match.px = fromLevel(aligned.px, s.level);
  match.inv_distance = triangulateInverseDistance(q.camera, q.T_cur_ref, q.f_ref, match.px);
  if (!(match.inv_distance > 0) || !std::isfinite(match.inv_distance)) return match;
  const Vec3 f_back = q.T_cur_ref.quaternion().conjugate() * q.camera.bearing(match.px);
  if (f_back.cross(q.f_ref).norm() < std::sin(p.min_parallax_deg * kDegree)) {
    match.outcome = SearchOutcome::low_parallax;
    return match;
  }
  match.tau = inverseDistanceSigma(q.T_cur_ref, q.f_ref, match.inv_distance, p.pixel_noise,
                                   q.camera.focal());
  match.outcome = SearchOutcome::matched;
  return match;
}

SearchSetup prepareSearch(const EpipolarQuery& q, const EpipolarParameters& p) {
  Prepared s;
  SearchSetup setup;
  setup.outcome = prepare(q, p, s);
  if (setup.outcome != SearchOutcome::matched) return setup;
  setup.px_near = s.line.near;
  setup.px_far = s.line.far;
  setup.level = s.level;
  setup.length_px = (s.line.near - s.line.far).norm() / (1 << s.level);
  setup.patch = s.patch;
  return setup;
}

std::vector<ProfileSample> scoreProfile(const EpipolarQuery& q, const EpipolarParameters& p) {
  std::vector<ProfileSample> samples;
  Prepared s;
  if (prepare(q, p, s) != SearchOutcome::matched) return samples;
  const ScoreTemplate score(s.patch);
  const cv::Mat& image = (*q.cur)[s.level];
  walkLine(s.line, s.level, p, [&](int x, int y) {
    if (!insideForScore(image, x, y)) return;
    const Vec2 px = fromLevel(Vec2(x, y), s.level);
    samples.push_back(
        {px, triangulateInverseDistance(q.camera, q.T_cur_ref, q.f_ref, px), score(image, x, y)});
  });
  std::sort(samples.begin(), samples.end(), [](const ProfileSample& a, const ProfileSample& b) {
    return a.inv_distance < b.inv_distance;
  });
  return samples;
}

}  // namespace svoscope
