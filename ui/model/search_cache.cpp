// SPDX-License-Identifier: MIT
#include "ui/model/search_cache.h"

#include <algorithm>
#include <cmath>

#include "ui/model/seed_trace.h"
#include "ui/widgets/controls.h"

namespace svoscope::ui {

namespace {

const KeyframeView* findKeyframe(const Snapshot* snapshot, int id) {
  if (!snapshot || !snapshot->keyframes) return nullptr;
  for (const KeyframeView& k : *snapshot->keyframes) {
    if (k.id == id) return &k;
  }
  return nullptr;
}

/// `later`, or in its place a snapshot with nothing but the keyframe and its image: those of a
/// recording hold the image of their own frame only.
SnapshotPtr withKeyframeImage(const RunView& run, int keyframe, const Snapshot& searched,
                              SnapshotPtr later) {
  const KeyframeView* now = findKeyframe(&searched, keyframe);
  const KeyframeView* known = now ? now : findKeyframe(later.get(), keyframe);
  if (!known || known->pyramid) return later;
  const SnapshotPtr frame = run.at(known->frame_index);
  if (!frame || !frame->pyramid) return later;
  KeyframeView complete = *known;
  complete.pyramid = frame->pyramid;
  auto snapshot = std::make_shared<Snapshot>();
  snapshot->keyframes = std::make_shared<const std::vector<KeyframeView>>(1, complete);
  return snapshot;
}

}  // namespace

const SearchDetail* SearchCache::find(const RunView& run, const SeedView& seed,
                                      const SeedUpdateView& update, int update_index,
                                      int published) {
  const Key key{update.seed_id, update.frame_index, update_index, run.generation()};
  if (key == key_) return detail_ ? &*detail_ : nullptr;
  key_ = key;
  ++version_;
  detail_.reset();
  problem_.clear();
  const SnapshotPtr searched = run.at(update.frame_index);
  if (!searched) {
    problem_ = format("Frame %d, which was searched, is no longer held", update.frame_index);
    return nullptr;
  }
  ++computed_;
  // Knows a keyframe made after the searched frame.
  const SnapshotPtr later = withKeyframeImage(run, seed.keyframe_id, *searched, run.at(published));
  const Result<SearchDetail> result =
      explainSearch(seed, update, *searched, run.info(), later.get());
  if (result.ok())
    detail_ = result.value();
  else
    problem_ = result.error().message();
  return detail_ ? &*detail_ : nullptr;
}

std::vector<Vec2f> warpedFootprint(const SeedView& seed, const SeedUpdateView& update,
                                   const Snapshot& searched, const Pinhole& camera,
                                   int search_level) {
  const BeliefView& belief = firstComputed(update.before);
  if (!searched.keyframes || !(belief.mu > 0) || camera.fx <= 0) return {};
  const KeyframeView* keyframe = nullptr;
  for (const KeyframeView& k : *searched.keyframes) {
    if (k.id == seed.keyframe_id) keyframe = &k;
  }
  if (!keyframe) return {};
  const SE3 T_cur_ref = searched.record.T_world_cam.inverse() * keyframe->T_world_cam;
  const Vec2 center = seed.px_ref.cast<double>();
  const double depth = camera.bearing(center).z() / belief.mu;  // a plane parallel to the image
  const auto toCurrent = [&](const Vec2& px) {
    return T_cur_ref * Vec3(depth * camera.unproject(px));
  };
  const Vec3 middle = toCurrent(center), right = toCurrent(center + Vec2(4, 0)),
             down = toCurrent(center + Vec2(0, 4));
  if (middle.z() <= 0 || right.z() <= 0 || down.z() <= 0) return {};
  Mat2 A;  // current px per reference px
  A.col(0) = (camera.project(right) - camera.project(middle)) / 4;
  A.col(1) = (camera.project(down) - camera.project(middle)) / 4;
  if (std::abs(A.determinant()) < 1e-6 || !A.allFinite()) return {};
  const Mat2 back = A.inverse();
  const double half = 4.0 * (1 << std::clamp(search_level, 0, 8));
  std::vector<Vec2f> corners;
  for (const Vec2& corner :
       {Vec2(-half, -half), Vec2(half, -half), Vec2(half, half), Vec2(-half, half)}) {
    corners.push_back((center + back * corner).cast<float>());
  }
  return corners;
}

namespace {

bool belowLimit(const SearchDetail& d) {
  return d.best >= 0 && d.best < static_cast<int>(d.profile.size()) &&
         d.profile[static_cast<std::size_t>(d.best)].score < d.max_score;
}

}  // namespace

bool bestAccepted(const SearchDetail& d) {
  return belowLimit(d) && d.outcome == SearchOutcome::matched;
}

std::string bestSampleText(const SearchDetail& d) {
  if (bestAccepted(d)) return "best, accepted";
  if (d.outcome == SearchOutcome::matched || d.outcome == SearchOutcome::tracked)
    return "best";  // measured elsewhere
  if (!belowLimit(d)) return "best, above the limit";
  if (d.outcome == SearchOutcome::no_match) return "best, no sub-pixel match";
  return std::string("best, ") + searchOutcomeName(d.outcome);
}

std::string profileCsv(const SearchDetail& d, std::int64_t seed, int frame) {
  std::string text = format("# seed %lld, frame %d, %s, max score %g, best %d, second %d\n",
                            static_cast<long long>(seed), frame, searchOutcomeName(d.outcome),
                            d.max_score, d.best, d.second);
  text += "sample,inverse_distance,px_x,px_y,score\n";
  for (std::size_t i = 0; i < d.profile.size(); ++i) {
    const SearchSample& s = d.profile[i];
    text += format("%d,%.9g,%.3f,%.3f,%.6g\n", static_cast<int>(i), s.inv_distance, s.px.x(),
                   s.px.y(), s.score);
  }
  return text;
}

}  // namespace svoscope::ui
