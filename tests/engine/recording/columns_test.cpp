// SPDX-License-Identifier: MIT
// Names of columns are part of the format: they stay when the rule table grows.
#include "engine/recording/columns.h"

#include <gtest/gtest.h>

#include "engine/recording/schema.h"

namespace svoscope {
namespace {

/// Names of a list "a, b, c", without columns of rules beyond the first two.
std::string namesOfFormat2(const std::string& list) {
  std::string kept;
  for (std::size_t from = 0; from < list.size();) {
    const std::size_t end = std::min(list.find(", ", from), list.size());
    const std::string name = list.substr(from, end - from);
    from = end + 2;
    bool other = false;
    for (std::size_t i = 2; i < kRuleCount; ++i) {
      const std::string id = kRuleTable[i].id;
      other |= name.rfind(id + "_before_", 0) == 0 || name.rfind(id + "_after_", 0) == 0;
    }
    if (!other) kept += (kept.empty() ? "" : ", ") + name;
  }
  return kept;
}

TEST(Columns, OfSeedUpdatesAreThoseOfTheFormat) {
  EXPECT_EQ(namesOfFormat2(seedUpdateColumns().names),
            "seed_id, keyframe_id, searched_frame, outcome, px_x, px_y, score, x, tau, "
            "kl_before_mu, kl_before_sigma, kl_before_a, kl_before_b, "
            "kl_after_mu, kl_after_sigma, kl_after_a, kl_after_b, "
            "js_before_mu, js_before_sigma, js_before_a, js_before_b, "
            "js_after_mu, js_after_sigma, js_after_a, js_after_b, "
            "kl_belief_measurement, kl_measurement_belief, jsd, affinity");
}

TEST(Columns, EveryRuleHasItsOwnBeforeAndAfter) {
  const std::string names = seedUpdateColumns().names;
  for (const RuleInfo& rule : kRuleTable) {
    for (const char* when : {"_before_", "_after_"}) {
      for (const char* field : {"mu", "sigma", "a", "b"})
        EXPECT_NE(names.find(rule.id + std::string(when) + field), std::string::npos) << rule.id;
    }
  }
}

TEST(Columns, OfSeedStatesKeepTheirOrder) {
  std::string names;
  const auto note = [&](const std::string& name, const auto&) {
    for (std::size_t i = 2; i < kRuleCount; ++i) {
      if (name == kRuleTable[i].id) return;
    }
    names += (names.empty() ? "" : ", ") + name;
  };
  const SeedView seed;
  visitSeedState(note, seed);
  EXPECT_EQ(
      names,
      "keyframe_id, type, status, ending, outcome, level, direction, px_ref, mu, sigma, a, b, "
      "kl, js, range, updates, failures, px_ref_end, mu_end, sigma_end, last_x, last_tau, "
      "true_inv_distance");
}

TEST(Columns, MoreRulesMakeAnotherVersionOfTheFormat) {
  EXPECT_EQ(kSchemaVersion % 1000, 2);
  EXPECT_EQ(kSchemaVersion / 1000, static_cast<std::int64_t>(kRuleCount) - 2);
}

}  // namespace
}  // namespace svoscope
