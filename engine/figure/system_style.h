// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "engine/figure/style.h"

namespace svoscope {

/// Colour and dash of a method (engine/base/methods.h); anything else has those of the default one.
FigureStyle methodStyle(const std::string& method);

/// For what has no colour of its own, such as external trajectories: Okabe-Ito colours the methods
/// do not use, dashed from the sixth on.
FigureStyle otherStyle(int number);

}  // namespace svoscope
