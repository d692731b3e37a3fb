// SPDX-License-Identifier: MIT
// How a line is told from others wherever it is drawn: in the window, in figures and in reports.
#pragma once

#include <cstdint>

namespace svoscope {

/// Colour is never the only cue: every line has its own pattern, too.
enum class Dash : std::uint8_t { solid, dashed, dotted };

struct Look {
  std::uint32_t rgb = 0;  ///< 0xRRGGBB
  Dash dash = Dash::solid;
};

}  // namespace svoscope
