// SPDX-License-Identifier: MIT
// How the camera moves: its velocity, its last good pose and how well features usually fit. From
// these the pose of the next frame is predicted.
#pragma once

#include <vector>

#include "engine/tracking/map_adjustment.h"
#include "engine/tracking/registration.h"

namespace svoscope {

class Motion {
 public:
  /// The first pose on a new map, and the motion that led to it.
  void begin(const SE3& T_cam_world, const SE3& T_cur_last);
  /// A frame was registered after the good frame `last`.
  void moved(const Frame& frame, const Frame& last);
  /// A frame was registered after a loss: nothing is known of the velocity.
  void foundAt(const SE3& T_cam_world);
  void stop() { T_velocity_ = SE3(); }
  /// Takes the noise of a registered frame into the running mean.
  void noteNoise(double noise_px);
  /// Goes along with a keyframe that an adjustment moved.
  void follow(const KeyframeChange& change);

  /// Constant velocity and standing still, the one with the smaller photometric error first; then
  /// the rotation between the images as wholes.
  std::vector<Prediction> predict(const Frame& frame, const Frame& last, const Pinhole& camera,
                                  const TrackerParameters& parameters) const;

  const SE3& velocity() const { return T_velocity_; }
  const SE3& lastGoodPose() const { return T_last_good_; }
  double usualNoisePx() const { return usual_noise_px_; }

 private:
  SE3 T_velocity_;             ///< T_cur_last of the last two good frames
  SE3 T_last_good_;            ///< T_cam_world of the last good frame
  double usual_noise_px_ = 0;  ///< of frames with a good pose, running mean; 0: there was none
};

}  // namespace svoscope
