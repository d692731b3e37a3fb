// SPDX-License-Identifier: MIT
#pragma once

#include "engine/mapping/map.h"

namespace svoscope {

/// Gauss-Newton on the position of a corner landmark over the bearings of its keyframes,
/// reprojection error on the unit plane; at most `max_iterations` steps, undone if the error rises.
/// Edgelets and landmarks with fewer than two views stay. Returns true if the position changed.
bool refineLandmark(Landmark& landmark, const Map& map, int max_iterations);

}  // namespace svoscope
