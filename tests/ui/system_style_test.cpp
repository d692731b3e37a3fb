// SPDX-License-Identifier: MIT
// Reports and inspector give a method the same colour.
#include "engine/figure/system_style.h"

#include <gtest/gtest.h>

#include "ui/palette.h"

namespace svoscope {
namespace {

TEST(SystemStyle, MethodsHaveTheColoursOfTheInspector) {
  for (const char* method : {"svo", "pl-svo", "it-svo"}) {
    const ImU32 c = ui::methodColor(method);
    char text[8];
    std::snprintf(text, sizeof(text), "#%02x%02x%02x", (c >> IM_COL32_R_SHIFT) & 255u,
                  (c >> IM_COL32_G_SHIFT) & 255u, (c >> IM_COL32_B_SHIFT) & 255u);
    EXPECT_EQ(methodStyle(method).color, text) << method;
  }
}

}  // namespace
}  // namespace svoscope
