// SPDX-License-Identifier: MIT
#include "engine/tracking/start.h"

namespace svoscope {

namespace {

InitializerFrame imageOf(const Frame& frame) {
  return {frame.index, frame.timestamp, frame.pyramid};
}

}  // namespace

Start::Start(const Pinhole& camera, const InitializerParameters& parameters)
    : camera_(camera), initializer_(camera, parameters) {}

const InitializerOutput& Start::process(const Frame& frame) {
  output_ = initializer_.process(imageOf(frame));
  return output_;
}

std::optional<InitializerOutput> Start::processBeside(const Frame& frame,
                                                      const InitializerParameters& parameters) {
  if (!beside_) beside_ = std::make_unique<Initializer>(camera_, parameters);
  InitializerOutput output = beside_->process(imageOf(frame));
  if (!output.initialized) return std::nullopt;
  return output;
}

SE3 startVelocity(const InitializerOutput& start) {
  const auto& poses = start.poses;
  if (poses.size() < 2) return SE3();
  const InitializerPose& last = poses[poses.size() - 2];
  const InitializerPose& current = poses.back();
  if (current.frame_index != last.frame_index + 1) return SE3();
  return current.T_frame_ref * last.T_frame_ref.inverse();
}

}  // namespace svoscope
