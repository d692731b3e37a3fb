// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "engine/figure/svg_plot.h"

namespace svoscope {

/// One colour and dash per method, those of the inspector: "svo", "pl-svo", "it-svo". Anything else
/// has the colour of it-svo.
SvgStyle methodStyle(const std::string& method);

/// For what has no colour of its own, such as external trajectories: Okabe-Ito colours the methods
/// do not use, dashed from the sixth on.
SvgStyle otherStyle(int number);

}  // namespace svoscope
