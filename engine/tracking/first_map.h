// SPDX-License-Identifier: MIT
// The first map: what the start found becomes a keyframe, landmarks and the features of a frame.
#pragma once

#include "engine/tracking/frame.h"
#include "engine/tracking/initializer.h"

namespace svoscope {

/// Adds the reference of the start as a keyframe with its points, and gives `frame`, the second
/// view, its pose and features. The world is the reference camera, in units of its median depth.
/// Returns the keyframe's id.
int buildFirstMap(const InitializerOutput& start, Map& map, Frame& frame);

}  // namespace svoscope
