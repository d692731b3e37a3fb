// SPDX-License-Identifier: MIT
#include "engine/figure/style.h"

#include <fmt/format.h>

namespace svoscope {

FigureStyle styleOf(const Look& look) {
  const char* dash = look.dash == Dash::dashed ? "7 3" : look.dash == Dash::dotted ? "2 2" : "";
  return {fmt::format("#{:06x}", look.rgb), dash};
}

}  // namespace svoscope
