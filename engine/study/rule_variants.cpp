// SPDX-License-Identifier: MIT
#include "engine/study/rule_variants.h"

namespace svoscope {

namespace {

/// One term of a rule, the others switched off.
struct Term {
  FilterRule rule;
  const char* name;
  RuleSettings settings;
  Look look;
};
constexpr Term kTerms[] = {
    {FilterRule::js, "fuse only", {{true, false}}, {0xcc79a7, Dash::dashed}},
    {FilterRule::js, "weight only", {{false, true}}, {0x009e73, Dash::solid}}};

std::vector<RuleVariant> makeVariants() {
  std::vector<RuleVariant> variants;
  for (const FilterRule rule : kRules) {
    const RuleInfo& info = ruleInfo(rule);
    const std::string label = info.label;
    bool apart = false;
    for (const Term& term : kTerms) {
      if (term.rule != rule) continue;
      variants.push_back({label + " " + term.name, rule, term.settings, term.look, false});
      apart = true;
    }
    variants.push_back({apart ? label + " both" : label, rule, {}, info.look, true});
  }
  return variants;
}

}  // namespace

const std::vector<RuleVariant>& ruleVariants() {
  static const std::vector<RuleVariant> variants = makeVariants();
  return variants;
}

const RuleVariant* findRuleVariant(const std::string& name) {
  for (const RuleVariant& variant : ruleVariants()) {
    if (variant.name == name) return &variant;
  }
  return nullptr;
}

}  // namespace svoscope
