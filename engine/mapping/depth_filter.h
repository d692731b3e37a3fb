// SPDX-License-Identifier: MIT
// The Gaussian x Beta depth filter (Vogiatzis & Hernandez, IVC 2011) on inverse distance: one
// measurement updates the belief q(z, rho) = N(z | mu, sigma^2) Beta(rho | a, b). docs/filters.md.
#pragma once

#include <array>

#include "engine/base/rules.h"

namespace svoscope {

/// Belief of a seed. Inverse distance in 1/map unit.
struct Belief {
  double mu = 1;
  double sigma2 = 1;  ///< variance, (1/map unit)^2
  double a = 10, b = 10;

  double inlierRatio() const { return a / (a + b); }
};

/// One measurement: inverse distance x with variance tau2; `range` is the width of the uniform
/// component R.
struct Measurement {
  double x = 0, tau2 = 1, range = 1;
};

/// The two terms of the JS rule, switched apart to see what each of them does.
struct JsSwitches {
  bool fuse_variance = true;          ///< tau' of (22) in place of tau
  bool weight_responsibility = true;  ///< C1 scaled by the affinity w
};

/// What the rules can be told; each reads its own part.
struct RuleSettings {
  JsSwitches js;
};

/// A rule: the belief after one measurement. The belief is returned unchanged where the measurement
/// is not finite or the result would not be.
using UpdateFunction = Belief (*)(const Belief&, const Measurement&, const RuleSettings&);

/// One function per row of the rule table, each in a file of its own in engine/mapping/rules/.
namespace rules {
#define SVOSCOPE_RULE(id, label, rgb, dash) \
  Belief id(const Belief& belief, const Measurement& m, const RuleSettings& settings);
SVOSCOPE_FILTER_RULES(SVOSCOPE_RULE)
#undef SVOSCOPE_RULE
}  // namespace rules

inline constexpr std::array<UpdateFunction, kRuleCount> kUpdateFunctions{
#define SVOSCOPE_RULE(id, label, rgb, dash) &rules::id,
    SVOSCOPE_FILTER_RULES(SVOSCOPE_RULE)
#undef SVOSCOPE_RULE
};

inline Belief updateBelief(FilterRule rule, const Belief& belief, const Measurement& m,
                           const RuleSettings& settings = {}) {
  return kUpdateFunctions[static_cast<std::size_t>(rule)](belief, m, settings);
}

/// Moment matching of the exact one-step posterior (Kullback-Leibler projection; paper (9)-(10)),
/// of which rules are made. `weight` scales the inlier responsibility C1 (1 = the KL rule).
Belief momentMatch(const Belief& belief, const Measurement& m, double weight);

}  // namespace svoscope
