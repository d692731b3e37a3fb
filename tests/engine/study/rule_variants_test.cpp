// SPDX-License-Identifier: MIT
#include "engine/study/rule_variants.h"

#include <gtest/gtest.h>

#include <set>

namespace svoscope {
namespace {

TEST(RuleVariants, HoldEveryRuleOnceAndTheTermsOfJs) {
  std::set<std::string> names;
  ByRule<int> whole;
  for (const RuleVariant& variant : ruleVariants()) {
    EXPECT_TRUE(names.insert(variant.name).second) << variant.name;
    EXPECT_EQ(findRuleVariant(variant.name), &variant);
    whole[variant.rule] += variant.whole;
    if (!variant.whole) continue;
    EXPECT_EQ(variant.look.rgb, ruleInfo(variant.rule).look.rgb) << variant.name;
    EXPECT_EQ(variant.name.rfind(ruleInfo(variant.rule).label, 0), 0u) << variant.name;
  }
  for (const FilterRule rule : kRules) EXPECT_EQ(whole[rule], 1) << ruleInfo(rule).id;
  const char* first[] = {"KL", "JS fuse only", "JS weight only", "JS both"};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(ruleVariants()[i].name, first[i]);
  EXPECT_FALSE(findRuleVariant("JS fuse only")->settings.js.weight_responsibility);
  EXPECT_FALSE(findRuleVariant("JS weight only")->settings.js.fuse_variance);
  EXPECT_EQ(findRuleVariant("js"), nullptr);
}

}  // namespace
}  // namespace svoscope
