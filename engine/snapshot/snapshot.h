// SPDX-License-Identifier: MIT
// The contract with the outside: what one frame looked like to the engine, as immutable plain
// values. No pointers into the engine; large parts are shared between consecutive snapshots.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "engine/base/kinds.h"
#include "engine/base/rules.h"
#include "engine/geometry/camera.h"
#include "engine/geometry/trajectory.h"
#include "engine/snapshot/frame_record.h"

namespace svoscope {

using Vec2f = Eigen::Vector2f;
using Vec3f = Eigen::Vector3f;

/// One feature of the current frame. Pixels are of the rectified image at level 0.
struct FeatureView {
  std::int64_t id = -1;  ///< landmark id or seed id (origin says which); track id at the start
  FeatureType type = FeatureType::corner;
  FeatureOrigin origin = FeatureOrigin::landmark;
  FeatureStatus status = FeatureStatus::inlier;
  std::uint8_t level = 0;    ///< pyramid level of the patch
  Vec2f px = Vec2f::Zero();  ///< measured; for a track at the start: current position
  Vec2f predicted_px =
      Vec2f::Zero();             ///< projected with the final pose; for a track: first position
  Vec2f px_end = Vec2f::Zero();  ///< segments: the other end point
  float direction = 0;           ///< edgelets: angle of the gradient, radians
  float depth = 0;               ///< z in the camera, map scale
  float residual_px = 0;         ///< reprojection error at level 0
  int observations = 0;          ///< keyframes that see the landmark; updates of the seed
  int reference_keyframe = -1;
};

/// The state of one rule of the depth filter. Inverse distance in 1/map unit. sigma == 0: this rule
/// was not computed (shadow filter off).
struct BeliefView {
  float mu = 0, sigma = 0;
  float a = 10, b = 10;
};

/// One measurement of a seed, and what every rule made of it.
struct SeedUpdateView {
  std::int64_t seed_id = -1;
  int keyframe_id = -1;
  int frame_index = -1;  ///< frame that was searched; older than its keyframe for new seeds
  SearchOutcome outcome = SearchOutcome::none;
  Vec2f px = Vec2f::Zero();  ///< match in that frame, level 0; if matched or tracked
  float score = 0;           ///< zero-mean SSD per pixel of the best sample; 0: no scan
  float x = 0, tau = 0;      ///< measured inverse distance and its sigma, 1/map unit
  ByRule<BeliefView> before, after;
  float kl_belief_measurement = 0;  ///< KL(belief || measurement), nats, of the rule in use
  float kl_measurement_belief = 0;  ///< KL(measurement || belief), nats
  float jsd = 0;                    ///< Jensen-Shannon divergence, nats, 0 .. log 2
  float affinity = 0;               ///< w of docs/method.md, 0 .. 1
};

/// One seed after the frame: its belief over inverse depth (along the ray of unit length, 1/map
/// unit) and what the last search did.
struct SeedView {
  std::int64_t id = -1;
  int keyframe_id = -1;
  FeatureType type = FeatureType::corner;
  SeedStatus status = SeedStatus::active;
  SeedEnding ending = SeedEnding::none;  ///< shown once, in the frame in which it ended
  SearchOutcome outcome = SearchOutcome::none;
  std::uint8_t level = 0;
  float direction = 0;            ///< edgelets: angle of the gradient in the reference, radians
  Vec2f px_ref = Vec2f::Zero();   ///< in its reference keyframe
  float mu = 0, sigma = 0;        ///< of the rule in use: inverse distance, 1/map unit
  float a = 10, b = 10;           ///< Beta parameters of the inlier ratio
  ByRule<BeliefView> belief;      ///< all rules on the same measurements (shadow filter)
  float range = 1;                ///< R of the uniform component, 1/map unit
  int updates = 0;                ///< successful measurements
  int failures = 0;               ///< searches without a match
  bool visible = false;           ///< mean projects into the current image
  Vec2f px = Vec2f::Zero();       ///< mean in the current image
  Vec2f px_near = Vec2f::Zero();  ///< mu + n sigma in the current image
  Vec2f px_far = Vec2f::Zero();   ///< mu - n sigma in the current image
  Vec2f px_ref_end =
      Vec2f::Zero();  ///< segments: the other end point; mu and sigma above are of px_ref
  float mu_end = 0, sigma_end = 0;  ///< segments: belief of the other end point; a and b are shared
  Vec3f position = Vec3f::Zero();   ///< mean in the world
  Vec3f position_end = Vec3f::Zero();  ///< segments: the other end point
  Vec3f position_near = Vec3f::Zero(), position_far = Vec3f::Zero();  ///< ends of the span
  float last_x = 0, last_tau = 0;  ///< last measurement (inverse distance) and its sigma
  float true_inv_distance = 0;     ///< from the sequence's depth, metres; 0 if unknown
};

struct MappingParameters;

struct KeyframeView {
  int id = -1;
  int frame_index = -1;
  SE3 T_world_cam;
  std::shared_ptr<const std::vector<cv::Mat>>
      pyramid;         ///< rectified, CV_8UC1; shared with its frame
  bool in_map = true;  ///< false: removed from the map since, the pose is its last
};

struct MapPointView {
  std::int64_t id = -1;
  Vec3f position = Vec3f::Zero();
  Vec3f position_end = Vec3f::Zero();  ///< segments: the other end point
  FeatureType type = FeatureType::corner;
  float sigma = 0;  ///< of inverse depth when promoted
  int observations = 0;
  int reference_keyframe = -1;
};

enum class EventKind : std::uint8_t {
  info,
  initialized,
  keyframe,
  lost,
  relocalized,
  warning,
  reset,
  finished,
  error
};
struct Event {
  int frame_index = -1;
  EventKind kind = EventKind::info;
  std::string text;
};

struct Snapshot {
  std::uint64_t sequence_number = 0;  ///< increases by one per published snapshot
  FrameRecord record;
  /// Rectified image, CV_8UC1, levels 0..n; never written after publishing.
  std::shared_ptr<const std::vector<cv::Mat>> pyramid;
  std::vector<FeatureView> features;
  std::shared_ptr<const std::vector<SeedView>> seeds;
  /// Measurements applied to seeds since the snapshot before.
  std::shared_ptr<const std::vector<SeedUpdateView>> seed_updates;
  /// What searches and filters of this frame ran with; explainSearch() takes it. May be null.
  std::shared_ptr<const MappingParameters> mapping;
  std::shared_ptr<const std::vector<KeyframeView>> keyframes;  ///< poses as of this frame
  std::shared_ptr<const std::vector<MapPointView>> points;
  std::vector<Event> events;  ///< of this frame

  /// Bytes held by this snapshot alone (shared parts counted where first shared).
  std::size_t bytes = 0;
};
using SnapshotPtr = std::shared_ptr<const Snapshot>;

/// What stays the same during a run.
struct RunInfo {
  std::string sequence;  ///< Sequence::name()
  std::string method;    ///< id of engine/base/methods.h, "pl-svo"
  int frames = 0;
  double rate_hz = 0;
  Pinhole camera;                  ///< of the rectified images
  Camera original_camera;          ///< as calibrated
  Trajectory ground_truth;         ///< empty if unknown
  std::string truth_note;          ///< why it is empty, if the sequence has one
  std::string times = "listed";    ///< where the times of the images come from: "assumed", ...
  std::vector<std::string> notes;  ///< what was assumed when the sequence was opened
};

}  // namespace svoscope
