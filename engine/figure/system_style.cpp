// SPDX-License-Identifier: MIT
#include "engine/figure/system_style.h"

#include <array>

#include "engine/base/methods.h"

namespace svoscope {

FigureStyle methodStyle(const std::string& method) { return styleOf(methodLook(method)); }

FigureStyle otherStyle(int number) {
  static const std::array<const char*, 5> kColors = {"#009e73", "#0072b2", "#d55e00", "#8c6d1f",
                                                     "#7f7f7f"};
  const int count = static_cast<int>(kColors.size());
  const int n = number < 0 ? 0 : number;
  return {kColors[static_cast<std::size_t>(n % count)], n < count ? "" : "5 3"};
}

}  // namespace svoscope
