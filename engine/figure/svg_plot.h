// SPDX-License-Identifier: MIT
#pragma once

#include "engine/figure/style.h"

namespace svoscope {

using SvgStyle = FigureStyle;

}  // namespace svoscope
