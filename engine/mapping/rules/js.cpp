// SPDX-License-Identifier: MIT
// The rule of IT-SVO. The paper leaves tau_h^2 of (22), "the variance introduced by the JS
// divergence", open; our reading: tau_h^2 = Var(m) / w with the mixture m of belief and
// measurement.
#include "engine/mapping/rules/js.h"

#include <algorithm>

namespace svoscope {

namespace {
constexpr double kMinAffinity = 1e-6;  // keeps C1 and tau_h defined at the limit log 2
}

Belief updateJs(const Belief& q, const Measurement& m, const JsSwitches& switches,
                const Agreement& agreement) {
  const double w = std::clamp(agreement.affinity, kMinAffinity, 1.0);
  Measurement fused = m;
  if (switches.fuse_variance) {
    const double offset = q.mu - m.x;
    const double mixture = 0.5 * (q.sigma2 + m.tau2) + 0.25 * offset * offset;  // Var((p + q) / 2)
    fused.tau2 = 1.0 / (1.0 / m.tau2 + w / mixture);  // (22), tau_h^2 = Var / w
  }
  return momentMatch(q, fused, switches.weight_responsibility ? w : 1.0);
}

Belief rules::js(const Belief& q, const Measurement& m, const RuleSettings& settings) {
  return updateJs(q, m, settings.js, agreement(q.mu, q.sigma2, m.x, m.tau2));
}

}  // namespace svoscope
