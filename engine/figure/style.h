// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "engine/base/look.h"

namespace svoscope {

/// How a system or rule is drawn, everywhere. Colour is never the only cue.
struct FigureStyle {
  std::string color;   ///< "#56b4e9"; empty: that of the ground truth
  std::string dash;    ///< lengths of dash and gap in px, as in SVG: "6 3"; empty: solid
  double opacity = 1;  ///< of bars and dots
};

/// A method or rule as its table says (engine/base/methods.h, rules.h).
FigureStyle styleOf(const Look& look);

}  // namespace svoscope
