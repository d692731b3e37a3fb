// SPDX-License-Identifier: MIT
#include "engine/base/rules.h"

#include <gtest/gtest.h>

#include <cctype>
#include <set>
#include <string>

#include "engine/base/methods.h"
#include "engine/mapping/depth_filter.h"

namespace svoscope {
namespace {

/// Ids are parts of column names, parameters and the script language.
bool plain(const std::string& id) {
  if (id.empty()) return false;
  for (const char c : id) {
    if (!std::islower(static_cast<unsigned char>(c)) && c != '_') return false;
  }
  return true;
}

TEST(Rules, EveryRowHasIdLabelLookAndFunction) {
  std::set<std::string> ids, labels;
  std::set<std::uint32_t> colours;
  ASSERT_EQ(kRules.size(), kRuleTable.size());
  for (const FilterRule rule : kRules) {
    const RuleInfo& info = ruleInfo(rule);
    EXPECT_TRUE(plain(info.id)) << info.id;
    EXPECT_STRNE(info.label, "") << info.id;
    EXPECT_TRUE(ids.insert(info.id).second) << info.id << " occurs twice";
    EXPECT_TRUE(labels.insert(info.label).second) << info.label << " occurs twice";
    EXPECT_TRUE(info.look.rgb > 0 && info.look.rgb <= 0xffffff) << info.id;
    EXPECT_TRUE(colours.insert(info.look.rgb).second) << info.id << " has the colour of another";
    ASSERT_NE(kUpdateFunctions[static_cast<std::size_t>(rule)], nullptr) << info.id;
    const Belief before{0.5, 0.01, 10, 10}, after = updateBelief(rule, before, {0.52, 1e-4, 1});
    EXPECT_LT(after.sigma2, before.sigma2) << info.id << " learns nothing from a measurement";
    EXPECT_GT(after.mu, before.mu) << info.id;
  }
}

TEST(Rules, IdsAndPlacesOfRecordedRulesStay) {
  EXPECT_STREQ(ruleInfo(FilterRule::kl).id, "kl");
  EXPECT_STREQ(ruleInfo(FilterRule::js).id, "js");
  EXPECT_EQ(static_cast<int>(FilterRule::kl), 0);
  EXPECT_EQ(static_cast<int>(FilterRule::js), 1);
}

TEST(Rules, ByRuleIsOneValuePerRule) {
  ByRule<int> values;
  values.fill(3);
  values[FilterRule::js] = 5;
  EXPECT_EQ(values[FilterRule::kl], 3);
  EXPECT_EQ(values[FilterRule::js], 5);
  int count = 0;
  for (const int v : values) count += v > 0;
  EXPECT_EQ(count, static_cast<int>(kRuleCount));
}

TEST(Methods, AreFoundByIdAndAreUnique) {
  std::set<std::string> ids, labels;
  std::set<std::uint32_t> colours;
  for (const std::string& id : methodIds()) {
    const MethodInfo* method = findMethod(id);
    ASSERT_NE(method, nullptr) << id;
    EXPECT_EQ(method->id, id);
    EXPECT_TRUE(ids.insert(id).second) << id;
    EXPECT_TRUE(labels.insert(method->label).second) << id;
    EXPECT_TRUE(colours.insert(method->look.rgb).second) << id << " has the colour of another";
    EXPECT_EQ(methodLook(id).rgb, method->look.rgb);
  }
  EXPECT_EQ(findMethod("SVO"), nullptr);
  EXPECT_EQ(findMethod(""), nullptr);
  ASSERT_NE(findMethod(kDefaultMethod), nullptr);
  EXPECT_EQ(methodLook("orb").rgb, findMethod(kDefaultMethod)->look.rgb);
}

TEST(Methods, OfThePaperAreWhatTheySay) {
  EXPECT_EQ(findMethod("svo")->rule, FilterRule::kl);
  EXPECT_FALSE(findMethod("svo")->segments);
  EXPECT_EQ(findMethod("pl-svo")->rule, FilterRule::kl);
  EXPECT_TRUE(findMethod("pl-svo")->segments);
  EXPECT_EQ(findMethod("it-svo")->rule, FilterRule::js);
  EXPECT_TRUE(findMethod("it-svo")->segments);
}

}  // namespace
}  // namespace svoscope
