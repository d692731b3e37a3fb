// SPDX-License-Identifier: MIT
#include "engine/tracking/initializer_reference.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/quantile.h"
#include "engine/tracking/initializer.h"

namespace svoscope {

namespace {

constexpr double kEdgeletPriorPx = 2.0;  // how well neighbours predict an edge point, px
constexpr double kMaxSurprisePx = 12;    // how far from their prediction lost tracks are taken, px
constexpr int kMaxMissed = 10;           // frames a track may be missing (blur, occlusion)

/// Median motion since the last frame of the corners found nearest to a track; zero if there are
/// too few.
Vec2 neighbourMotion(const std::vector<StartTrack>& tracks, const StartTrack& of) {
  constexpr std::size_t kNeighbours = 5;
  std::vector<std::pair<double, Vec2>> near;
  for (const StartTrack& t : tracks)
    if (t.found) near.emplace_back((t.px - t.motion - of.px).squaredNorm(), t.motion);
  if (near.size() < kNeighbours) return Vec2::Zero();
  std::nth_element(near.begin(), near.begin() + kNeighbours - 1, near.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<double> x, y;
  for (std::size_t i = 0; i < kNeighbours; ++i) {
    x.push_back(near[i].second.x());
    y.push_back(near[i].second.y());
  }
  return {upperMedian(x), upperMedian(y)};
}

}  // namespace

InitializerReference::InitializerReference(const InitializerFrame& frame,
                                           const InitializerParameters& parameters,
                                           std::int64_t first_id)
    : index_(frame.index),
      timestamp_(frame.timestamp),
      pyramid_(frame.pyramid),
      parameters_(parameters) {
  for (const StartFeature& feature : detectStartFeatures(*pyramid_, parameters.max_tracks)) {
    StartTrack track;
    track.id = first_id++;
    track.feature = feature;
    track.px = feature.px;
    track.patch = makeKltTemplate(*pyramid_, feature.px, A_cur_ref_, parameters.klt);
    tracks_.push_back(std::move(track));
  }
  alive_ = static_cast<int>(tracks_.size());
}

double InitializerReference::aliveRatio() const {
  return tracks_.empty() ? 0 : static_cast<double>(alive_) / static_cast<double>(tracks_.size());
}

void InitializerReference::track(const InitializerFrame& frame) {
  trackCorners(*frame.pyramid);
  trackOthers(*frame.pyramid);
  updateWarp();
  record(frame);
}

void InitializerReference::trackCorners(const std::vector<cv::Mat>& pyramid) {
  for (StartTrack& t : tracks_) {
    t.found = false;
    if (!t.alive || t.feature.type != FeatureType::corner) continue;
    renewPatch(t);
    KltResult found = trackKlt(t.patch, pyramid, t.px, {}, parameters_.klt);
    // Fast steady motion can exceed the reach of the coarsest level: try where it was heading.
    if (!found.ok) found = trackKlt(t.patch, pyramid, t.px + t.motion, {}, parameters_.klt);
    if (!found.ok) continue;
    t.found = true;
    t.motion = found.px - t.px;
    t.px = found.px;
  }
}

void InitializerReference::trackOthers(const std::vector<cv::Mat>& pyramid) {
  for (StartTrack& t : tracks_) {
    if (t.found || t.missed > kMaxMissed) continue;
    renewPatch(t);
    const bool edgelet = t.feature.type == FeatureType::edgelet;
    const Vec2 motion = neighbourMotion(tracks_, t);
    const Vec2 guess = t.px + motion;
    const KltPrior prior = edgelet ? KltPrior{guess, kEdgeletPriorPx} : KltPrior{};
    const KltResult found = trackKlt(t.patch, pyramid, guess, prior, parameters_.klt);
    // What comes back far from where its neighbours went is another thing.
    t.alive = found.ok && (found.px - guess).norm() < kMaxSurprisePx;
    t.missed = t.alive ? 0 : t.missed + 1;
    t.motion = t.alive ? Vec2(found.px - t.px) : motion;
    t.px = t.alive ? found.px : guess;
  }
}

void InitializerReference::renewPatch(StartTrack& track) const {
  // Templates are cut out anew only when they look clearly different by now.
  if ((track.patch.A_cur_ref - A_cur_ref_).norm() < 0.07) return;
  track.patch = makeKltTemplate(*pyramid_, track.feature.px, A_cur_ref_, parameters_.klt);
}

void InitializerReference::updateWarp() {
  Vec2 mean_ref = Vec2::Zero(), mean_cur = Vec2::Zero();
  double count = 0;
  for (const StartTrack& t : tracks_) {
    if (!t.alive) continue;
    mean_ref += t.feature.px;
    mean_cur += t.px;
    count += 1;
  }
  if (count < 10) return;
  mean_ref /= count;
  mean_cur /= count;
  double along = 0, across = 0, sum = 0;
  for (const StartTrack& t : tracks_) {
    if (!t.alive) continue;
    const Vec2 r = t.feature.px - mean_ref, c = t.px - mean_cur;
    along += r.dot(c);
    across += r.x() * c.y() - r.y() * c.x();
    sum += r.squaredNorm();
  }
  const double a = along / sum, b = across / sum, scale = std::hypot(a, b);
  if (!(scale > 0.4 && scale < 2.5)) return;
  A_cur_ref_ << a, -b, b, a;
}

void InitializerReference::record(const InitializerFrame& frame) {
  TrackedFrame out;
  out.index = frame.index;
  out.timestamp = frame.timestamp;
  std::vector<double> moved;
  for (const StartTrack& t : tracks_) {
    constexpr float kLost = std::numeric_limits<float>::quiet_NaN();
    out.px.emplace_back(Eigen::Vector2f::Constant(kLost));
    if (t.alive) out.px.back() = t.px.cast<float>();
    if (t.alive) moved.push_back((t.px - t.feature.px).norm());
  }
  alive_ = static_cast<int>(moved.size());
  out.disparity_px = upperMedian(moved);
  frames_.push_back(std::move(out));
}

}  // namespace svoscope
