// SPDX-License-Identifier: MIT
#include "engine/figure/style.h"

#include <array>

namespace svoscope {

FigureStyle numberedStyle(std::size_t number) {
  static const std::array<FigureStyle, 4> kStyles = {
      {{"#0072b2", ""}, {"#e69f00", "4 4"}, {"#009e73", "9 9"}, {"#d55e00", ""}}};
  return kStyles[number % kStyles.size()];
}

}  // namespace svoscope
