// SPDX-License-Identifier: MIT
#include "engine/tracking/relocalizer.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "engine/tracking/segment_tracking.h"

namespace svoscope {

namespace {

constexpr int kThumbnailWidth = 40;

/// Rotation about the optical centre that best matches the thumbnails, by trying small shifts: one
/// thumbnail pixel is about two degrees.
SE3 shiftRotation(const cv::Mat& ref, const cv::Mat& cur, const Pinhole& camera,
                  double& similarity) {
  constexpr int kReach = 4;
  double best = -2;
  int bx = 0, by = 0;
  for (int dy = -kReach; dy <= kReach; ++dy) {
    for (int dx = -kReach; dx <= kReach; ++dx) {
      const cv::Rect a(std::max(0, dx), std::max(0, dy), ref.cols - std::abs(dx),
                       ref.rows - std::abs(dy));
      const cv::Rect b(std::max(0, -dx), std::max(0, -dy), a.width, a.height);
      const cv::Mat pa = ref(b), pb = cur(a);
      const double norm = cv::norm(pa) * cv::norm(pb);
      const double s = norm > 0 ? pa.dot(pb) / norm : 0;
      if (s > best) {
        best = s;
        bx = dx;
        by = dy;
      }
    }
  }
  similarity = best;
  const double px_per_cell = static_cast<double>(camera.width) / ref.cols;
  // Content moving right by bx cells means that the camera turned left.
  const Vec3 omega(-by * px_per_cell / camera.fy, bx * px_per_cell / camera.fx, 0);
  return SE3(so3Exp(omega), Vec3::Zero());
}

}  // namespace

cv::Mat makeThumbnail(const Pyramid& pyramid) {
  cv::Mat small, blurred, thumbnail;
  const cv::Mat& coarse = pyramid.back();
  const int height = std::max(1, kThumbnailWidth * coarse.rows / coarse.cols);
  cv::resize(coarse, small, cv::Size(kThumbnailWidth, height), 0, 0, cv::INTER_AREA);
  small.convertTo(blurred, CV_32F);
  cv::GaussianBlur(blurred, thumbnail, cv::Size(0, 0), 1.2);
  thumbnail -= cv::mean(thumbnail)[0];
  const double norm = cv::norm(thumbnail);
  if (norm > 0) thumbnail *= 1.0 / norm;
  return thumbnail;
}

SE3 registeredRotation(const Pyramid& ref, const Pyramid& cur, const Pinhole& camera) {
  double similarity = 0;
  return shiftRotation(makeThumbnail(ref), makeThumbnail(cur), camera, similarity);
}

std::vector<AlignmentPatch> keyframePatches(const Map& map, const Keyframe& keyframe) {
  std::vector<AlignmentPatch> patches;
  for (const std::int64_t id : keyframe.landmarks) {
    const Landmark* landmark = map.find(id);
    if (!landmark) continue;
    for (const LandmarkObservation& o : landmark->observations) {
      if (o.keyframe_id != keyframe.id) continue;
      const double distance = (keyframe.T_cam_world * landmark->p_world).norm();
      patches.push_back({o.anchor.px, o.anchor.f * distance});
    }
  }
  for (const Seed& seed : keyframe.seeds) {
    if (seed.status == SeedStatus::converged)
      patches.push_back({seed.anchor.px, seed.anchor.f / seed.belief.mu});
  }
  constexpr int kPerSegment = 3;
  for (const std::int64_t id : keyframe.segments) {
    const SegmentLandmark& segment = map.segments.at(id);
    const auto view =
        std::find_if(segment.views.begin(), segment.views.end(),
                     [&](const SegmentView& v) { return v.keyframe_id == keyframe.id; });
    if (view == segment.views.end()) continue;
    const ImageLine line = lineThrough(view->anchor.px[0], view->anchor.px[1]);
    appendPatchesAlong(map.camera, keyframe.T_cam_world * segment.p_world[0],
                       keyframe.T_cam_world * segment.p_world[1], line, kPerSegment, patches);
  }
  return patches;
}

std::vector<RelocalizationCandidate> similarKeyframes(const Map& map, const Pyramid& pyramid,
                                                      int most, double min_similarity) {
  const cv::Mat thumbnail = makeThumbnail(pyramid);
  std::vector<RelocalizationCandidate> ranked;
  for (const auto& [id, keyframe] : map.keyframes) {
    if (keyframe.thumbnail.size() != thumbnail.size()) continue;
    RelocalizationCandidate c;
    c.keyframe_id = id;
    c.T_cam_world = shiftRotation(keyframe.thumbnail, thumbnail, map.camera, c.similarity) *
                    keyframe.T_cam_world;
    if (c.similarity >= min_similarity) ranked.push_back(c);
  }
  std::sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) {
    return a.similarity != b.similarity ? a.similarity > b.similarity
                                        : a.keyframe_id > b.keyframe_id;
  });
  if (static_cast<int>(ranked.size()) > most) ranked.resize(static_cast<std::size_t>(most));
  return ranked;
}

std::vector<RelocalizationCandidate> relocalizationCandidates(
    const Map& map, const Pyramid& pyramid, const SparseAlignmentParameters& alignment,
    const RelocalizerParameters& p) {
  std::vector<RelocalizationCandidate> ranked =
      similarKeyframes(map, pyramid, p.candidates, p.min_similarity);
  SparseAlignmentParameters coarse = alignment;
  coarse.max_level = static_cast<int>(pyramid.size()) - 1;
  coarse.max_iterations = 30;
  std::vector<RelocalizationCandidate> found;
  for (RelocalizationCandidate& c : ranked) {
    const Keyframe& keyframe = map.keyframes.at(c.keyframe_id);
    const auto patches = keyframePatches(map, keyframe);
    const SE3 T_kf_world_inv = keyframe.T_cam_world.inverse();
    const SparseAlignmentResult aligned = alignSparse(
        *keyframe.pyramid, pyramid, map.camera, patches, c.T_cam_world * T_kf_world_inv, coarse);
    if (!aligned.ok || aligned.patches < p.min_patches) continue;
    c.T_cam_world = aligned.T_cur_ref * keyframe.T_cam_world;
    found.push_back(c);
  }
  return found;
}

}  // namespace svoscope
