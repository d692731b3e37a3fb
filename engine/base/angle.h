// SPDX-License-Identifier: MIT
// Degrees in parameters and texts, radians in computations.
#pragma once

#include <cmath>

namespace svoscope {

constexpr double kDegree = M_PI / 180.0;  ///< in radians

}  // namespace svoscope
