// SPDX-License-Identifier: MIT
// Keyframes, landmarks and seeds. Owned and changed by the tracking thread alone: the mapping
// thread gets copies of what it needs and answers with values (seed_update.h).
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <unordered_map>
#include <vector>

#include "engine/base/kinds.h"
#include "engine/frame/pyramid.h"
#include "engine/geometry/camera.h"
#include "engine/geometry/se3.h"
#include "engine/mapping/depth_filter.h"
#include "engine/mapping/seed_life.h"
#include "engine/mapping/segment_seed.h"

namespace svoscope {

/// A pixel with its patch: what a keyframe saw.
struct FeatureAnchor {
  Vec2 px = Vec2::Zero();  ///< level 0
  Vec3 f = Vec3::UnitZ();  ///< unit bearing
  int level = 0;
  FeatureType type = FeatureType::corner;
  Vec2 gradient_dir = Vec2::Zero();  ///< edgelets, unit
};

struct Seed : SeedLife {
  FeatureAnchor anchor;    ///< in its keyframe
  Belief belief;           ///< of the rule in use: decides status and map
  ByRule<Belief> shadow;   ///< of the other rules, on the same measurements; for inspection
  bool has_shadow = true;  ///< no measurement was kept from them
  double score = 0;        ///< of the detector
  double last_x = 0, last_tau = 0;
};

struct LandmarkObservation {
  int keyframe_id = -1;
  FeatureAnchor anchor;
};

struct Landmark {
  std::int64_t id = -1;
  Vec3 p_world = Vec3::Zero();
  FeatureType type = FeatureType::corner;
  std::vector<LandmarkObservation> observations;  ///< first: where it was detected
  double sigma = 0;                               ///< of inverse distance in the first observation
  int succeeded = 0, failed = 0;  ///< frames that tried it: inlier of the pose or not
  double score = 0;
};

struct Keyframe {
  int id = -1, frame_index = -1;
  double timestamp = 0;
  PyramidPtr pyramid;
  SE3 T_cam_world;
  double median_depth = 1, min_depth = 0.5;  ///< z of its features, map units
  double scale = 1;                     ///< product of the factors its surroundings were scaled by
  std::vector<std::int64_t> landmarks;  ///< seen in it
  std::vector<Seed> seeds;              ///< in order of id
  std::vector<std::int64_t> segments;   ///< segment landmarks seen in it
  std::vector<SegmentSeed> segment_seeds;  ///< in order of id
  cv::Mat thumbnail;                       ///< small blurred float image, zero mean
  int last_local_frame = -1;               ///< last frame that searched its features
};

/// What is left of a keyframe that was removed from the map.
struct RetiredKeyframe {
  int id = -1, frame_index = -1;
  SE3 T_world_cam;
};

/// A seed that went with its keyframe.
struct OrphanSeed {
  Seed seed;
  SE3 T_cam_world;  ///< of the removed keyframe
};
struct OrphanSegmentSeed {
  SegmentSeed seed;
  SE3 T_cam_world;
};

struct Map {
  Pinhole camera;
  std::vector<RetiredKeyframe> retired;  ///< by id
  std::map<int, Keyframe> keyframes;     ///< by id: ordered, so that runs are repeatable
  std::unordered_map<std::int64_t, Landmark> landmarks;
  std::map<std::int64_t, SegmentLandmark> segments;
  std::vector<OrphanSeed> orphans;  ///< of keyframes removed during the last frame
  std::vector<OrphanSegmentSeed> segment_orphans;
  std::int64_t next_id = 0;  ///< of landmarks, segments and seeds of both
  int next_keyframe_id = 0;

  Landmark* find(std::int64_t id) {
    const auto it = landmarks.find(id);
    return it == landmarks.end() ? nullptr : &it->second;
  }
  const Landmark* find(std::int64_t id) const { return const_cast<Map*>(this)->find(id); }
  Keyframe* findKeyframe(int id) {
    const auto it = keyframes.find(id);
    return it == keyframes.end() ? nullptr : &it->second;
  }

  const Keyframe* findKeyframe(int id) const { return const_cast<Map*>(this)->findKeyframe(id); }
  Seed* findSeed(int keyframe_id, std::int64_t id) {
    Keyframe* keyframe = findKeyframe(keyframe_id);
    return keyframe ? findById(keyframe->seeds, id) : nullptr;
  }
  SegmentSeed* findSegmentSeed(int keyframe_id, std::int64_t id) {
    Keyframe* keyframe = findKeyframe(keyframe_id);
    return keyframe ? findById(keyframe->segment_seeds, id) : nullptr;
  }

  Landmark& addLandmark(const Vec3& p_world, FeatureType type);
  void addObservation(Landmark& landmark, Keyframe& keyframe, const FeatureAnchor& anchor);
  void removeLandmark(std::int64_t id);
  void removeSegment(std::int64_t id);
  void removeSegmentView(std::int64_t id, int keyframe_id);
  /// Takes back one view; a landmark left with fewer than two goes.
  void removeObservation(std::int64_t landmark_id, int keyframe_id);
  /// Ends all seeds of a keyframe; they are kept as orphans until the next frame.
  void endSeeds(Keyframe& keyframe, SeedEnding ending);
  /// Removes the keyframe, its seeds and its observations; landmarks left with fewer than two
  /// observations go too.
  void removeKeyframe(int id);
  int seedCount() const;
};

/// Observation whose viewing ray is closest to the direction from the camera centre `c_world`;
/// null if all differ by more than `max_angle_cos` allows.
const LandmarkObservation* closestView(const Map& map, const Landmark& landmark,
                                       const Vec3& c_world, double min_cosine);

}  // namespace svoscope
