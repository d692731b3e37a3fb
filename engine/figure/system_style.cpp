// SPDX-License-Identifier: MIT
#include "engine/figure/system_style.h"

#include <array>

namespace svoscope {

SvgStyle methodStyle(const std::string& method) {
  // Okabe-Ito orange, purple and sky, as ui/palette.cpp has them; a test compares the two.
  if (method == "svo") return {"#e69f00", "7 3"};
  if (method == "pl-svo") return {"#cc79a7", "2 2"};
  return {"#56b4e9", ""};
}

SvgStyle otherStyle(int number) {
  static const std::array<const char*, 5> kColors = {"#009e73", "#0072b2", "#d55e00", "#8c6d1f",
                                                     "#7f7f7f"};
  const int count = static_cast<int>(kColors.size());
  const int n = number < 0 ? 0 : number;
  return {kColors[static_cast<std::size_t>(n % count)], n < count ? "" : "5 3"};
}

}  // namespace svoscope
