// SPDX-License-Identifier: MIT
#include "engine/runner/search_detail.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "engine/mapping/seed_update.h"

namespace svoscope {

namespace {

constexpr int kReferenceSize = 24;
constexpr double kDistinctPx = 3;  // of the search level, between best and second

const KeyframeView* findKeyframe(const Snapshot* snapshot, int id) {
  if (!snapshot || !snapshot->keyframes) return nullptr;
  for (const KeyframeView& keyframe : *snapshot->keyframes) {
    if (keyframe.id == id && keyframe.pyramid) return &keyframe;
  }
  return nullptr;
}

EpipolarQuery queryOf(const SeedView& seed, const SeedUpdateView& update,
                      const KeyframeView& keyframe, const Snapshot& searched, const RunInfo& info,
                      FilterRule rule) {
  EpipolarQuery q;
  q.ref = keyframe.pyramid.get();
  q.cur = searched.pyramid.get();
  q.camera = info.camera;
  q.T_cur_ref = searched.record.T_world_cam.inverse() * keyframe.T_world_cam;
  q.px_ref = seed.px_ref.cast<double>();
  q.f_ref = info.camera.bearing(q.px_ref);
  q.level_ref = seed.level;
  q.type = seed.type;
  q.gradient_dir = Vec2(std::cos(seed.direction), std::sin(seed.direction));
  const BeliefView& before = update.before[rule];
  q.mu = before.mu;
  q.sigma = before.sigma;
  return q;
}

/// Pixel (half, half) of the patch is `px` (level 0).
cv::Mat cutPatch(const Pyramid& pyramid, const Vec2& px, int level, int size) {
  const cv::Mat& image = pyramid[static_cast<std::size_t>(level)];
  const Vec2 at = toLevel(px, level);
  cv::Mat patch;
  cv::getRectSubPix(image, cv::Size(size, size),
                    cv::Point2f(static_cast<float>(at.x() - 0.5), static_cast<float>(at.y() - 0.5)),
                    patch);
  return patch;
}

cv::Mat imageOf(const WarpedPatch& patch) {
  cv::Mat image(kPatchSize, kPatchSize, CV_8UC1);
  for (int i = 0; i < kPatchSize; ++i) {
    for (int j = 0; j < kPatchSize; ++j)
      image.at<std::uint8_t>(i, j) = cv::saturate_cast<std::uint8_t>(patch.inner(i, j));
  }
  return image;
}

void markBest(SearchDetail& detail) {
  const auto& profile = detail.profile;
  const auto bestOf = [&](const auto& allowed) {
    int best = -1;
    for (std::size_t i = 0; i < profile.size(); ++i) {
      if (allowed(profile[i]) &&
          (best < 0 || profile[i].score < profile[static_cast<std::size_t>(best)].score))
        best = static_cast<int>(i);
    }
    return best;
  };
  detail.best = bestOf([](const SearchSample&) { return true; });
  if (detail.best < 0) return;
  const Vec2f px = profile[static_cast<std::size_t>(detail.best)].px;
  const double distinct = kDistinctPx * (1 << detail.search_level);
  detail.second = bestOf([&](const SearchSample& s) { return (s.px - px).norm() >= distinct; });
}

}  // namespace

Result<SearchDetail> explainSearch(const SeedView& seed, const SeedUpdateView& update,
                                   const Snapshot& searched, const RunInfo& info,
                                   const Snapshot* later) {
  const std::string where = "seed " + std::to_string(seed.id);
  const KeyframeView* keyframe = findKeyframe(&searched, seed.keyframe_id);
  if (!keyframe) keyframe = findKeyframe(later, seed.keyframe_id);
  if (!keyframe)
    return inputError("the image of its keyframe is no longer held", where,
                      "choose a later update");
  if (!searched.pyramid || searched.pyramid->empty())
    return inputError("the searched image is no longer held", where, "choose a later update");
  const MappingParameters p = searched.mapping ? *searched.mapping : MappingParameters();
  const EpipolarQuery q = queryOf(seed, update, *keyframe, searched, info, p.filter.rule);
  if (seed.level >= q.ref->size())
    return inputError("its pyramid level is not held", where, "choose another seed");

  SearchDetail detail;
  detail.outcome = update.outcome;
  detail.max_score = static_cast<float>(p.search.max_score);
  detail.patch_reference = cutPatch(*q.ref, q.px_ref, q.level_ref, kReferenceSize);
  const SearchSetup setup = prepareSearch(q, p.search);
  if (setup.outcome != SearchOutcome::matched) return detail;
  detail.search_level = setup.level;
  detail.px_near = setup.px_near.cast<float>();
  detail.px_far = setup.px_far.cast<float>();
  detail.patch_warped = imageOf(setup.patch);
  if (setup.length_px >= p.search.short_line_px) {
    for (const ProfileSample& s : scoreProfile(q, p.search))
      detail.profile.push_back(
          {s.px.cast<float>(), static_cast<float>(s.inv_distance), static_cast<float>(s.score)});
  }
  markBest(detail);
  if (update.outcome == SearchOutcome::matched || update.outcome == SearchOutcome::tracked) {
    detail.px_match = update.px;
    detail.patch_match = cutPatch(*q.cur, update.px.cast<double>(), setup.level, kPatchSize);
  }
  return detail;
}

}  // namespace svoscope
