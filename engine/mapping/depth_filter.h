// SPDX-License-Identifier: MIT
// The Gaussian x Beta depth filter (Vogiatzis & Hernandez, IVC 2011) on inverse distance: one
// measurement updates the belief q(z, rho) = N(z | mu, sigma^2) Beta(rho | a, b). docs/method.md.
#pragma once

#include <cstdint>

#include "engine/mapping/divergence.h"

namespace svoscope {

/// How one measurement changes a belief. KL: SVO and PL-SVO; JS: IT-SVO.
enum class FilterRule : std::uint8_t { kl, js };

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

/// Moment matching of the exact one-step posterior (Kullback-Leibler projection; paper (9)-(10)).
/// `weight` scales the inlier responsibility C1 (1 = the KL rule). The belief is returned
/// unchanged where the measurement is not finite or the result would not be.
Belief momentMatch(const Belief& belief, const Measurement& m, double weight);

/// The two terms of the JS rule, switched apart to see what each of them does.
struct JsSwitches {
  bool fuse_variance = true;          ///< tau' of (22) in place of tau
  bool weight_responsibility = true;  ///< C1 scaled by the affinity w
};

/// The rule of SVO and PL-SVO.
inline Belief updateKl(const Belief& belief, const Measurement& m) {
  return momentMatch(belief, m, 1.0);
}

/// The rule of IT-SVO. The paper leaves tau_h^2 of (22), "the variance introduced by the JS
/// divergence", open; our reading: tau_h^2 = Var(m) / w with the mixture m of belief and
/// measurement.
Belief updateJs(const Belief& belief, const Measurement& m, const JsSwitches& switches = {});
/// The same with an agreement of belief and measurement known already.
Belief updateJs(const Belief& belief, const Measurement& m, const JsSwitches& switches,
                const Agreement& agreement);

inline Belief updateBelief(FilterRule rule, const Belief& belief, const Measurement& m,
                           const JsSwitches& switches) {
  return rule == FilterRule::js ? updateJs(belief, m, switches) : updateKl(belief, m);
}

}  // namespace svoscope
