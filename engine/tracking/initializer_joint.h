// SPDX-License-Identifier: MIT
// The tracks of one reference frame as a joint problem over several frames.
#pragma once

#include <vector>

#include "engine/geometry/camera.h"
#include "engine/geometry/two_view_bundle.h"
#include "engine/tracking/initializer_parameters.h"
#include "engine/tracking/initializer_reference.h"

namespace svoscope {

/// The live tracks of a reference as a joint problem.
struct JointStart {
  std::vector<int> tracks;  ///< per point: index of its track
  std::vector<int> frames;  ///< per frame of the problem: index into reference.frames()
  MultiViewProblem problem;
  MultiViewSummary summary;
  double mean_cost = 0;  ///< truncated, per live track: to compare explanations
};

/// Points that agree with a pose of the last frame, and the frames between.
JointStart makeJoint(const InitializerReference& reference, const SE3& T_cur_ref,
                     const Pinhole& camera, const InitializerParameters& parameters);

/// Refines poses and depths, dropping in a few rounds what does not fit. `live`: tracks in all.
void refineJoint(JointStart& joint, const Pinhole& camera, int live);

/// Poses of all frames of the reference; those not refined jointly follow from the points.
std::vector<SE3> posesOfAllFrames(const InitializerReference& reference, const JointStart& joint,
                                  const Pinhole& camera);

/// Rms over all points and frames, px.
double rmsOf(const MultiViewSummary& summary);

/// Position on the unit plane of a pixel.
Vec2 unitPlane(const Pinhole& camera, const Vec2& px);

}  // namespace svoscope
