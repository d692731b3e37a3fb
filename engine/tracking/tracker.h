// SPDX-License-Identifier: MIT
// The odometry: one call registers a frame. No threads: the mapping job of a frame is taken from
// it and its result given back, by whoever runs it (engine/runner).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/mapping/seed_update.h"
#include "engine/snapshot/frame_record.h"
#include "engine/tracking/frame.h"
#include "engine/tracking/initializer.h"
#include "engine/tracking/keyframe_policy.h"
#include "engine/tracking/place_matching.h"
#include "engine/tracking/pose_refinement.h"
#include "engine/tracking/relocalizer.h"
#include "engine/tracking/reprojector.h"
#include "engine/tracking/segment_tracking.h"
#include "engine/tracking/sparse_alignment.h"

namespace svoscope {

struct QualityParameters {
  int min_inliers = 20;              ///< fewer after pose refinement: lost
  double min_inlier_fraction = 0.4;  ///< of the matched features; below: lost
  double min_tried_fraction =
      0.12;                      ///< of the features tried; below, a few edgelets may fit by chance
  int relocalized_inliers = 30;  ///< needed to accept a relocalisation ...
  double relocalized_fraction = 0.2;  ///< ... and this share of the features tried
  double relocalized_noise = 4;       ///< ... and errors at most so many times the usual ones
  int fresh_lost_frames = 10;  ///< lost for this long with a fresh map: look for another start, too
  int lost_frames = 60;        ///< the same with any other map
  int fresh_map_keyframes = 3;   ///< a map with at most this many keyframes is fresh
  int structure_iterations = 5;  ///< Gauss-Newton steps per landmark and frame
};

struct TrackerParameters {
  InitializerParameters start;
  SparseAlignmentParameters alignment;
  ReprojectorParameters reproject;
  PoseRefinementParameters pose;
  KeyframeParameters keyframe;
  QualityParameters quality;
  RelocalizerParameters relocalize;
  MappingParameters mapping;
};

class Tracker {
 public:
  Tracker(const Pinhole& camera, const TrackerParameters& parameters);

  /// Registers the next frame. `gray` is rectified, CV_8UC1, and is kept: the caller must not write
  /// it.
  const FrameRecord& process(int index, double timestamp, const cv::Mat& gray);

  /// Local bundle adjustment may be cut off by the clock (threads); a synchronous run never is.
  void setTimed(bool timed) { timed_ = timed; }
  /// Work for the mapping thread caused by the last frame, if any.
  std::optional<MappingJob> takeMappingJob();
  /// Applies what the mapping thread found, also for an older frame.
  void applyMapping(MappingResult result);
  /// Forgets map and motion, keeps the parameters.
  void reset();

  void setParameters(const TrackerParameters& parameters) { parameters_ = parameters; }
  const TrackerParameters& parameters() const { return parameters_; }

  const FrameRecord& record() const { return record_; }
  const Frame& frame() const { return frame_; }
  const Map& map() const { return map_; }
  /// Features that were tried in the last frame without success, for display.
  const std::vector<TrackedFeature>& failedFeatures() const { return failed_features_; }
  const std::vector<TrackedSegment>& failedSegments() const { return failed_segments_; }
  const std::vector<Event>& events() const { return events_; }
  const InitializerOutput& startOutput() const { return start_output_; }

  /// On: both rules of the depth filter run, and every update of a seed is kept until taken. Off by
  /// default: nobody looks.
  void setInspected(bool on) { inspected_ = on; }
  /// Updates applied since the last call.
  std::vector<SeedUpdateView> takeSeedUpdates() { return std::exchange(seed_updates_, {}); }

 private:
  struct Attempt;  ///< one try to register the frame from a predicted pose (tracker_attempt.h)
  /// Where the frame may be, relative to the last one.
  struct Prediction {
    SE3 T_cur_prev;
    const char* from = "";
    bool wide = false;  ///< by image registration, with a wider search
  };

  void initialize();
  void beginMap(InitializerOutput start);
  void startBeside();
  void trackFrame();
  void relocalize();
  bool tryRelocalization(const std::vector<RelocalizationCandidate>& candidates, const char* by,
                         std::string& failure);
  std::vector<Prediction> predictions(const std::vector<AlignmentPatch>& patches);
  bool trackFrom(const Prediction& prediction, const std::vector<AlignmentPatch>& patches,
                 Attempt& best);
  /// What takes part in an attempt.
  struct Scope {
    int coarser = 0;                ///< pyramid levels added to the search
    bool unconverged_seeds = true;  ///< found along long lines, they fit at many a wrong pose
  };
  Attempt attempt(const SE3& T_cam_world, const char* from, const Scope& scope);
  Attempt alignAndAttempt(const std::vector<AlignmentPatch>& patches, const SE3& T_cur_prev,
                          const char* from, const Scope& scope);
  bool accept(Attempt& a, int required);
  bool acceptRelocalization(Attempt& a);
  void countTries();
  void lose(const std::string& reason);
  void finishRecord();

  // Map changes (tracker_map.cpp, tracker_seeds.cpp).
  void buildMap(const InitializerOutput& start);
  void commitSeedMatches(const std::vector<TrackedSeedMatch>& matches);
  void refineStructure();
  KeyframeDecision considerKeyframe();
  void insertKeyframe(const std::string& reason);
  void promoteFeature(TrackedFeature& feature, Keyframe& keyframe);
  void requestSeeds(const Keyframe& keyframe);
  void requestMeasurements();
  void bringToScale(MappingResult& result) const;
  void addSeeds(Keyframe& keyframe, const MappingResult& result);
  void limitKeyframes();
  void requestAdjustment();                                  ///< tracker_adjustment.cpp
  void applyAdjustment(const AdjustmentResult& adjustment);  ///< tracker_adjustment.cpp
  void dropEndedSeeds();
  bool measureSeed(Seed& seed, const SeedMeasurement& m);

  // Segments (tracker_segments.cpp).
  std::vector<AlignmentPatch> alignmentPatches() const;
  void acceptSegments(Attempt& a);
  void commitSegments();
  void promoteSegments(Keyframe& keyframe);
  void refineSegments();
  void requestSegmentMeasurements();
  void applySegmentMapping(const MappingResult& result);
  void disownSegments(int keyframe_id);
  void followSegments();

  void event(EventKind kind, std::string text);

  TrackerParameters parameters_;
  Map map_;
  int map_id_ = 0;  ///< grows when a map is given up and another begun
  std::unique_ptr<Initializer> initializer_;
  InitializerOutput start_output_;
  std::unique_ptr<Initializer> restart_;  ///< while lost for long: a start beside relocalisation
  TrackingState state_ = TrackingState::initializing;
  Frame frame_, last_;
  SE3 T_velocity_;   ///< T_cur_last of the last two good frames
  SE3 T_last_good_;  ///< T_cam_world of the last good frame
  FrameRecord record_;
  std::vector<TrackedFeature> failed_features_;
  std::vector<TrackedSegment> failed_segments_;
  std::vector<Event> events_;
  std::vector<int> local_keyframes_;
  OccupancyGrid occupied_;
  PlaceIndex places_;
  std::optional<MappingJob> job_;
  std::vector<std::int64_t> measured_seeds_;  ///< by the tracker in this frame, sorted
  std::vector<SeedUpdateView> seed_updates_;
  bool inspected_ = false;
  int last_keyframe_frame_ = -1, lost_frames_ = 0;
  int latest_keyframe_ = -1;
  bool adjustment_wanted_ = false;  ///< a keyframe came after the last problem was built
  int awaited_adjustment_ = -1;  ///< newest keyframe of the problem that is being solved; -1: none
  bool timed_ = false;
  double usual_noise_px_ = 0;  ///< of frames with a good pose, running mean; 0: there was none
};

/// Median and 5 % quantile of the depth (z) of the frame's inliers; false if there are none.
bool depthStatistics(const Frame& frame, double& median, double& near);

}  // namespace svoscope
