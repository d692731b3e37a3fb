// SPDX-License-Identifier: MIT
#include "engine/tracking/motion.h"

#include <algorithm>

namespace svoscope {

void Motion::begin(const SE3& T_cam_world, const SE3& T_cur_last) {
  T_last_good_ = T_cam_world;
  T_velocity_ = T_cur_last;
}

void Motion::moved(const Frame& frame, const Frame& last) {
  T_velocity_ = frame.T_cam_world * last.T_cam_world.inverse();
  T_last_good_ = frame.T_cam_world;
}

void Motion::foundAt(const SE3& T_cam_world) {
  T_last_good_ = T_cam_world;
  stop();
}

void Motion::noteNoise(double noise_px) {
  constexpr double kNoiseUpdateRate = 0.05;  // about the last twenty frames
  usual_noise_px_ = usual_noise_px_ > 0
                        ? (1 - kNoiseUpdateRate) * usual_noise_px_ + kNoiseUpdateRate * noise_px
                        : noise_px;
}

void Motion::follow(const KeyframeChange& change) {
  T_last_good_ = change.followed(T_last_good_);
  T_velocity_ = SE3(T_velocity_.quaternion(), change.scale * T_velocity_.translation());
}

std::vector<Prediction> Motion::predict(const Frame& frame, const Frame& last,
                                        const Pinhole& camera, const TrackerParameters& p) const {
  const int top = std::min<int>(p.alignment.max_level, static_cast<int>(frame.pyramid->size()) - 1);
  const auto patches = alignmentPatches(last, camera, p.mapping.segments);
  const auto error = [&](const SE3& T_cur_last) {
    return photometricError(*last.pyramid, *frame.pyramid, camera, patches, T_cur_last, top);
  };
  std::vector<Prediction> list = {{T_velocity_}, {SE3()}};
  if (error(T_velocity_) > error(SE3())) std::swap(list[0], list[1]);
  list.push_back({SE3(), true});
  return list;
}

}  // namespace svoscope
