// SPDX-License-Identifier: MIT
// The rules of the depth filter: how one measurement changes a belief. A new rule is a row of this
// table and its function, rules::<id> in engine/mapping/rules/<id>.cpp; without the function the
// program does not link. Every rule of the table can be the rule of a method
// (engine/base/methods.h) and runs beside the one in use in inspected runs, recordings, charts, the
// lab and the depth study.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "engine/base/look.h"

// RULE(id, label, colour, pattern of its lines). The id names columns and parameters: once a rule
// was recorded, its id and its place in the table stay.
#define SVOSCOPE_FILTER_RULES(RULE)      \
  RULE(kl, "KL", 0xe69f00, Dash::dashed) \
  RULE(js, "JS", 0x56b4e9, Dash::solid)

namespace svoscope {

enum class FilterRule : std::uint8_t {
#define SVOSCOPE_RULE(id, label, rgb, dash) id,
  SVOSCOPE_FILTER_RULES(SVOSCOPE_RULE)
#undef SVOSCOPE_RULE
};

struct RuleInfo {
  const char* id;     ///< "kl": in files
  const char* label;  ///< "KL": for people
  Look look;
};

inline constexpr std::array kRuleTable{
#define SVOSCOPE_RULE(id, label, rgb, dash) RuleInfo{#id, label, {rgb, dash}},
    SVOSCOPE_FILTER_RULES(SVOSCOPE_RULE)
#undef SVOSCOPE_RULE
};
inline constexpr std::size_t kRuleCount = kRuleTable.size();

/// All rules, in the order of the table.
inline constexpr std::array kRules{
#define SVOSCOPE_RULE(id, label, rgb, dash) FilterRule::id,
    SVOSCOPE_FILTER_RULES(SVOSCOPE_RULE)
#undef SVOSCOPE_RULE
};

constexpr const RuleInfo& ruleInfo(FilterRule rule) {
  return kRuleTable[static_cast<std::size_t>(rule)];
}

/// One value per rule.
template <typename T>
struct ByRule {
  std::array<T, kRuleCount> values{};

  T& operator[](FilterRule rule) { return values[static_cast<std::size_t>(rule)]; }
  const T& operator[](FilterRule rule) const { return values[static_cast<std::size_t>(rule)]; }
  auto begin() { return values.begin(); }
  auto end() { return values.end(); }
  auto begin() const { return values.begin(); }
  auto end() const { return values.end(); }
  void fill(const T& value) { values.fill(value); }
};

}  // namespace svoscope
