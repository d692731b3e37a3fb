// SPDX-License-Identifier: MIT
#include "engine/tracking/place_matching.h"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/features2d.hpp>

namespace svoscope {

namespace {

constexpr int kLevels = 3;          // of the pyramid, with a factor of two
constexpr int kFeatures = 1000;     // in the image
constexpr int kRadius = 15;         // of the patch whose centroid gives the orientation, level px
constexpr float kMaxDistance = 64;  // of 256 bits
constexpr float kBestToSecond = 0.8f;
constexpr int kLeastMatches = 10, kLeastInliers = 8;
constexpr float kInlierPx = 4;

cv::Ptr<cv::ORB> makeOrb() {
  constexpr int kEdge = 19, kPatch = 31, kFastThreshold = 12;
  return cv::ORB::create(kFeatures, 2.0f, kLevels, kEdge, 0, 2, cv::ORB::HARRIS_SCORE, kPatch,
                         kFastThreshold);
}

/// Direction from the pixel to the intensity centroid of its disc, degrees; as ORB defines it.
float orientation(const cv::Mat& image, const Vec2& px) {
  const int cx = static_cast<int>(std::lround(px.x())), cy = static_cast<int>(std::lround(px.y()));
  double mx = 0, my = 0;
  for (int dy = -kRadius; dy <= kRadius; ++dy) {
    const int y = cy + dy;
    if (y < 0 || y >= image.rows) continue;
    const std::uint8_t* row = image.ptr<std::uint8_t>(y);
    for (int dx = -kRadius; dx <= kRadius; ++dx) {
      const int x = cx + dx;
      if (x < 0 || x >= image.cols || dx * dx + dy * dy > kRadius * kRadius) continue;
      mx += dx * row[x];
      my += dy * row[x];
    }
  }
  const double degrees = std::atan2(my, mx) * 180 / M_PI;
  return static_cast<float>(degrees < 0 ? degrees + 360 : degrees);
}

PlaceDescriptors describe(const Map& map, const Keyframe& keyframe) {
  std::vector<cv::KeyPoint> keypoints;
  std::vector<std::int64_t> ids;
  for (const std::int64_t id : keyframe.landmarks) {
    const Landmark* landmark = map.find(id);
    if (!landmark || landmark->type != FeatureType::corner) continue;
    const auto& views = landmark->observations;
    const auto view = std::find_if(views.begin(), views.end(), [&](const LandmarkObservation& o) {
      return o.keyframe_id == keyframe.id;
    });
    if (view == views.end()) continue;
    const int level =
        std::min({view->anchor.level, kLevels - 1, static_cast<int>(keyframe.pyramid->size()) - 1});
    const Vec2& px = view->anchor.px;
    const float angle =
        orientation((*keyframe.pyramid)[static_cast<std::size_t>(level)], toLevel(px, level));
    keypoints.emplace_back(static_cast<float>(px.x()), static_cast<float>(px.y()),
                           31.0f * static_cast<float>(1 << level), angle, 1.0f, level,
                           static_cast<int>(ids.size()));
    ids.push_back(id);
  }
  PlaceDescriptors place;
  if (keypoints.empty()) return place;
  makeOrb()->compute(keyframe.pyramid->front(), keypoints, place.descriptors);
  // Those near the border are gone: class_id says which are left.
  for (const cv::KeyPoint& k : keypoints)
    place.landmarks.push_back(ids[static_cast<std::size_t>(k.class_id)]);
  return place;
}

struct ImageFeatures {
  std::vector<cv::KeyPoint> keypoints;
  cv::Mat descriptors;
};

struct Matches {
  std::vector<cv::Point3d> points;  ///< world
  std::vector<cv::Point2d> pixels;
};

Matches match(const Map& map, const PlaceDescriptors& place, const ImageFeatures& image) {
  Matches matches;
  if (place.descriptors.rows < kLeastMatches) return matches;
  std::vector<std::vector<cv::DMatch>> pairs;
  cv::BFMatcher(cv::NORM_HAMMING).knnMatch(place.descriptors, image.descriptors, pairs, 2);
  for (const auto& pair : pairs) {
    if (pair.size() < 2 || pair[0].distance > kMaxDistance ||
        pair[0].distance > kBestToSecond * pair[1].distance)
      continue;
    const Landmark* landmark =
        map.find(place.landmarks[static_cast<std::size_t>(pair[0].queryIdx)]);
    if (!landmark) continue;
    const Vec3& p = landmark->p_world;
    const cv::Point2f& px = image.keypoints[static_cast<std::size_t>(pair[0].trainIdx)].pt;
    matches.points.emplace_back(p.x(), p.y(), p.z());
    matches.pixels.emplace_back(px.x, px.y);
  }
  return matches;
}

/// Inliers of the pose found; 0 if there is none.
int solvePose(const Pinhole& camera, const Matches& matches, SE3& T_cam_world) {
  if (static_cast<int>(matches.points.size()) < kLeastMatches) return 0;
  const cv::Matx33d K(camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
  cv::Mat rvec, tvec;
  std::vector<int> inliers;
  constexpr int kTrials = 300;
  constexpr double kConfidence = 0.999;
  const bool ok =
      cv::solvePnPRansac(matches.points, matches.pixels, K, cv::noArray(), rvec, tvec, false,
                         kTrials, kInlierPx, kConfidence, inliers, cv::SOLVEPNP_EPNP);
  if (!ok || static_cast<int>(inliers.size()) < kLeastInliers) return 0;
  const Vec3 w(rvec.at<double>(0), rvec.at<double>(1), rvec.at<double>(2));
  const Vec3 t(tvec.at<double>(0), tvec.at<double>(1), tvec.at<double>(2));
  T_cam_world = SE3(so3Exp(w), t);
  return T_cam_world.finite() ? static_cast<int>(inliers.size()) : 0;
}

}  // namespace

const PlaceDescriptors& PlaceIndex::of(const Map& map, const Keyframe& keyframe) {
  const auto it = places_.find(keyframe.id);
  return it != places_.end() ? it->second
                             : places_.emplace(keyframe.id, describe(map, keyframe)).first->second;
}

void PlaceIndex::keepOnly(const Map& map) {
  for (auto it = places_.begin(); it != places_.end();)
    it = map.keyframes.count(it->first) ? std::next(it) : places_.erase(it);
}

std::vector<RelocalizationCandidate> matchPlaces(const Map& map, const Pyramid& pyramid,
                                                 PlaceIndex& index,
                                                 const RelocalizerParameters& p) {
  ImageFeatures image;
  makeOrb()->detectAndCompute(pyramid.front(), cv::noArray(), image.keypoints, image.descriptors);
  std::vector<RelocalizationCandidate> found;
  if (image.descriptors.rows < kLeastMatches) return found;
  std::vector<std::pair<int, RelocalizationCandidate>> ranked;
  for (RelocalizationCandidate& c : similarKeyframes(map, pyramid, p.places, -1)) {
    const Keyframe& keyframe = map.keyframes.at(c.keyframe_id);
    const int inliers =
        solvePose(map.camera, match(map, index.of(map, keyframe), image), c.T_cam_world);
    if (inliers > 0) ranked.emplace_back(inliers, c);
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  for (const auto& [inliers, candidate] : ranked) {
    if (static_cast<int>(found.size()) < p.candidates) found.push_back(candidate);
  }
  return found;
}

}  // namespace svoscope
