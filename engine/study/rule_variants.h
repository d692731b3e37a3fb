// SPDX-License-Identifier: MIT
// What the lab and the depth study compare: every rule of the depth filter, and a rule's terms
// alone where it can be taken apart (docs/filters.md).
#pragma once

#include <string>
#include <vector>

#include "engine/mapping/depth_filter.h"

namespace svoscope {

struct RuleVariant {
  std::string name;  ///< "KL", "JS fuse only", "JS weight only", "JS both"
  FilterRule rule;
  RuleSettings settings;
  Look look;
  bool whole = true;  ///< the rule itself, not one of its terms
};

/// In the order of the rule table, the terms of a rule before the whole.
const std::vector<RuleVariant>& ruleVariants();

/// By name; null if there is none.
const RuleVariant* findRuleVariant(const std::string& name);

}  // namespace svoscope
