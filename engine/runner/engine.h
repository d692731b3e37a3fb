// SPDX-License-Identifier: MIT
// A sequence going through the tracker, frame by frame; who calls it decides about threads.
#pragma once

#include <memory>
#include <vector>

#include "engine/dataset/sequence.h"
#include "engine/frame/rectifier.h"
#include "engine/runner/parameters.h"
#include "engine/runner/snapshot_builder.h"

namespace svoscope {

class Engine {
 public:
  Engine(std::unique_ptr<Sequence> sequence, const Parameters& parameters, int start,
         int max_frames, std::string method);

  /// True if the last frame was processed.
  bool finished() const { return next_ >= end_; }
  int nextFrame() const { return next_; }

  /// Reads and registers the next frame. An unreadable image is a warning event and a row without
  /// a pose; the motion goes on from the last good frame.
  void step();
  std::optional<MappingJob> takeMappingJob() { return tracker_.takeMappingJob(); }
  void applyMapping(const MappingResult& result) { tracker_.applyMapping(result); }
  void setTimed(bool timed) { tracker_.setTimed(timed); }
  const MappingParameters& mappingParameters() const { return parameters_.tracker.mapping; }

  const FrameRecord& record() const { return record_; }
  const std::vector<Event>& events() const { return events_; }
  /// Snapshot of the last frame; adds its cost to the record.
  SnapshotPtr snapshot();
  /// Copies what mapping added to the frame's record after step().
  void refreshRecord();

  /// On: snapshots hold every rule of the depth filter and every seed update
  /// (Tracker::setInspected).
  void setInspected(bool on) { tracker_.setInspected(on); }

  /// Off: snapshots say what seeds believe, not where in the world and in the image that is.
  void setPlaced(bool on) { builder_.setPlaced(on); }

  Status setParameter(const std::string& key, const std::string& value);
  const Parameters& parameters() const { return parameters_; }
  void reset();
  const RunInfo& info() const { return info_; }

 private:
  void addNotes();
  cv::Mat rectifiedDepth(int frame_index);

  std::unique_ptr<Sequence> sequence_;
  Rectifier rectifier_;
  Parameters parameters_;
  Tracker tracker_;
  SnapshotBuilder builder_;
  RunInfo info_;
  FrameRecord record_;
  std::vector<Event> events_;
  bool image_good_ = false;
  int start_ = 0, end_ = 0, next_ = 0;
};

}  // namespace svoscope
