// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

namespace svoscope {

/// How a system or rule is drawn, everywhere. Colour is never the only cue.
struct FigureStyle {
  std::string color;   ///< "#56b4e9"; empty: that of the ground truth
  std::string dash;    ///< lengths of dash and gap in px, as in SVG: "6 3"; empty: solid
  double opacity = 1;  ///< of bars and dots
};

/// For series that have no look of their own, such as the rules of a study: four that differ in
/// Okabe-Ito colour, then again.
FigureStyle numberedStyle(std::size_t number);

}  // namespace svoscope
