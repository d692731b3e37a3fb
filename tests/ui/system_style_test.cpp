// SPDX-License-Identifier: MIT
// Reports and inspector give a method the same colour.
#include "engine/figure/system_style.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "engine/base/methods.h"
#include "ui/palette.h"

namespace svoscope {
namespace {

std::string hex(ImU32 c) {
  char text[8];
  std::snprintf(text, sizeof(text), "#%02x%02x%02x", (c >> IM_COL32_R_SHIFT) & 255u,
                (c >> IM_COL32_G_SHIFT) & 255u, (c >> IM_COL32_B_SHIFT) & 255u);
  return text;
}

TEST(SystemStyle, MethodsHaveTheColoursOfTheInspector) {
  for (const MethodInfo& method : kMethods) {
    EXPECT_EQ(methodStyle(method.id).color, hex(ui::methodColor(method.id))) << method.id;
    EXPECT_STREQ(ui::methodName(method.id), method.label);
  }
  EXPECT_EQ(methodStyle("svo").color, "#e69f00");
  EXPECT_EQ(methodStyle("svo").dash, "7 3");
  EXPECT_EQ(methodStyle("pl-svo").color, "#cc79a7");
  EXPECT_EQ(methodStyle("pl-svo").dash, "2 2");
  EXPECT_EQ(methodStyle("it-svo").color, "#56b4e9");
  EXPECT_EQ(methodStyle("it-svo").dash, "");
}

TEST(SystemStyle, RulesHaveTheColoursOfTheirTable) {
  EXPECT_EQ(ui::ruleColor(FilterRule::kl), ui::okabe::orange);
  EXPECT_EQ(ui::ruleColor(FilterRule::js), ui::okabe::sky);
  EXPECT_TRUE(ui::ruleDashed(FilterRule::kl));
  EXPECT_FALSE(ui::ruleDashed(FilterRule::js));
  EXPECT_STREQ(ui::ruleName(FilterRule::kl), "KL");
  EXPECT_STREQ(ui::ruleName(FilterRule::js), "JS");
}

}  // namespace
}  // namespace svoscope
