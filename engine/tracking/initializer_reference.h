// SPDX-License-Identifier: MIT
// One reference frame of the start and its tracks over the frames since.
#pragma once

#include <cstdint>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "engine/base/types.h"
#include "engine/geometry/se3.h"
#include "engine/tracking/initializer_features.h"
#include "engine/tracking/initializer_parameters.h"
#include "engine/tracking/klt.h"

namespace svoscope {

struct InitializerFrame;

/// A feature of the reference frame while it is followed.
struct StartTrack {
  std::int64_t id = -1;
  StartFeature feature;
  KltTemplate patch;
  Vec2 px = Vec2::Zero();      ///< position, level 0; carried along with its neighbours if missing
  Vec2 motion = Vec2::Zero();  ///< since the frame before
  bool alive = true;           ///< present in the last frame
  bool found = false;          ///< a corner found directly: a guide for the others
  int missed = 0;              ///< frames since it was last found
};

/// Positions of all tracks in one frame, in the order of the tracks; NaN where lost.
struct TrackedFrame {
  int index = -1;
  double timestamp = 0;
  double disparity_px = 0;  ///< median over live tracks
  std::vector<Eigen::Vector2f> px;
};

class InitializerReference {
 public:
  InitializerReference(const InitializerFrame& frame, const InitializerParameters& parameters,
                       std::int64_t first_id);

  /// Follows the tracks into the next frame.
  void track(const InitializerFrame& frame);

  int index() const { return index_; }
  double timestamp() const { return timestamp_; }
  const std::shared_ptr<const std::vector<cv::Mat>>& pyramid() const { return pyramid_; }
  const std::vector<StartTrack>& tracks() const { return tracks_; }
  const std::vector<TrackedFrame>& frames() const { return frames_; }
  int alive() const { return alive_; }
  double aliveRatio() const;
  double disparity() const { return frames_.empty() ? 0 : frames_.back().disparity_px; }

  double last_attempt_px = 0;  ///< disparity at the last attempt that failed
  int next_attempt_index = 0;  ///< frame before which a further one is not worth its time
  std::vector<SE3> hints;      ///< its pose: a start for the next attempt

 private:
  void trackCorners(const std::vector<cv::Mat>& pyramid);
  void trackOthers(const std::vector<cv::Mat>& pyramid);
  void updateWarp();
  void record(const InitializerFrame& frame);
  void renewPatch(StartTrack& track) const;

  int index_ = -1;
  double timestamp_ = 0;
  std::shared_ptr<const std::vector<cv::Mat>> pyramid_;
  InitializerParameters parameters_;
  std::vector<StartTrack> tracks_;
  std::vector<TrackedFrame> frames_;
  Mat2 A_cur_ref_ = Mat2::Identity();  ///< similarity fitted to all tracks
  int alive_ = 0;
};

}  // namespace svoscope
