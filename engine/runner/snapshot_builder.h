// SPDX-License-Identifier: MIT
// Turns the tracker's state into an immutable snapshot. Parts that did not change are shared with
// the snapshot before.
#pragma once

#include <functional>
#include <map>

#include "engine/snapshot/snapshot.h"
#include "engine/tracking/tracker.h"

namespace svoscope {

class SnapshotBuilder {
 public:
  /// True depth image (CV_32FC1, metres, rectified; may be empty) of a frame of the sequence.
  using DepthReader = std::function<cv::Mat(int frame_index)>;

  explicit SnapshotBuilder(DepthReader depth) : read_depth_(std::move(depth)) {}

  /// Of a frame that could not be read: numbered in turn, nothing in it.
  std::shared_ptr<Snapshot> buildEmpty();
  /// Takes the seed updates kept by the tracker.
  std::shared_ptr<Snapshot> build(Tracker& tracker);
  void reset();
  void setPlaced(bool on) { placed_ = on; }
  /// The next snapshot shows keyframes and points as they are then, whether the map changed or not.
  void showMapAnew() { keyframes_.reset(); }
  /// The next snapshot gets a new copy of the parameters.
  void parametersChanged() { mapping_.reset(); }

 private:
  std::shared_ptr<const std::vector<SeedView>> seedViews(const Tracker& tracker);
  std::shared_ptr<const std::vector<KeyframeView>> keyframeViews(const Tracker& tracker);
  std::shared_ptr<const std::vector<MapPointView>> pointViews(const Tracker& tracker);
  std::shared_ptr<const MappingParameters> mappingOf(const Tracker& tracker);
  const cv::Mat& depthOf(const Keyframe& keyframe);

  DepthReader read_depth_;
  bool placed_ = true;
  std::uint64_t sequence_number_ = 0;
  std::map<int, cv::Mat> depths_;  ///< by keyframe id
  std::shared_ptr<const std::vector<KeyframeView>> keyframes_;
  std::shared_ptr<const std::vector<MapPointView>> points_;
  std::shared_ptr<const MappingParameters> mapping_;
};

}  // namespace svoscope
