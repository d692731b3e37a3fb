// SPDX-License-Identifier: MIT
// The odometry: one call registers a frame. No threads: the mapping job of a frame is taken from
// it and its result given back, by whoever runs it (engine/runner).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/tracking/map_keeper.h"
#include "engine/tracking/motion.h"
#include "engine/tracking/recovery.h"
#include "engine/tracking/start.h"

namespace svoscope {

class Tracker {
 public:
  Tracker(const Pinhole& camera, const TrackerParameters& parameters);

  /// Registers the next frame. `gray` is rectified, CV_8UC1, and is kept: the caller must not write
  /// it.
  const FrameRecord& process(int index, double timestamp, const cv::Mat& gray);

  /// Local bundle adjustment may be cut off by the clock (threads); a synchronous run never is.
  void setTimed(bool timed) { keeper_.setTimed(timed); }
  /// Work for the mapping thread caused by the last frame, if any.
  std::optional<MappingJob> takeMappingJob() { return keeper_.takeJob(); }
  /// Applies what the mapping thread found, also for an older frame.
  void applyMapping(MappingResult result);
  /// Forgets map and motion, keeps the parameters.
  void reset();

  void setParameters(const TrackerParameters& parameters) { parameters_ = parameters; }
  const TrackerParameters& parameters() const { return parameters_; }

  const FrameRecord& record() const { return record_; }
  const Frame& frame() const { return frame_; }
  const Map& map() const { return keeper_.map(); }
  /// The attempt to register the last frame that was judged last, for the features that failed in
  /// it. Those that succeeded are the frame's if it was accepted.
  const Registration& registration() const { return registration_; }
  const std::vector<Event>& events() const { return events_; }
  const InitializerOutput& startOutput() const { return start_.output(); }

  /// On: every rule of the depth filter runs, and every update of a seed is kept until taken. Off
  /// by default: nobody looks.
  void setInspected(bool on) { keeper_.setInspected(on); }
  /// Updates applied since the last call.
  std::vector<SeedUpdateView> takeSeedUpdates() { return keeper_.takeSeedUpdates(); }

 private:
  void initialize();
  void trackFrame();
  void relocalize();
  void lose();
  void startBeside();
  void beginMap(const InitializerOutput& start);
  void note(Registration registration);
  void commit();
  void makeKeyframe(const std::string& reason);

  TrackerParameters parameters_;
  MapKeeper keeper_;
  Motion motion_;
  Start start_;
  Recovery recovery_;
  TrackingState state_ = TrackingState::initializing;
  int map_id_ = 0;  ///< grows when a map is given up and another begun
  Frame frame_, last_;
  Registration registration_;
  FrameRecord record_;
  std::vector<Event> events_;
};

}  // namespace svoscope
