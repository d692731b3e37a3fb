// SPDX-License-Identifier: MIT
// Seeds and their updates as plain values for display.
#include <algorithm>
#include <cmath>

#include "engine/mapping/divergence.h"
#include "engine/mapping/seed_update.h"

namespace svoscope {

BeliefView beliefView(const Seed& seed, FilterRule rule, FilterRule rule_in_use) {
  BeliefView v;
  const bool in_use = rule == rule_in_use;
  if (!in_use && !seed.has_shadow) return v;
  const Belief& q = in_use ? seed.belief : seed.shadow[rule];
  v.mu = static_cast<float>(q.mu);
  v.sigma = static_cast<float>(std::sqrt(q.sigma2));
  v.a = static_cast<float>(q.a);
  v.b = static_cast<float>(q.b);
  return v;
}

SeedUpdateView describeUpdate(const Seed& before, const Seed& after, const SeedMeasurement& m,
                              FilterRule rule_in_use) {
  SeedUpdateView v;
  v.seed_id = after.id;
  v.keyframe_id = after.keyframe_id;
  v.frame_index = m.frame_index;
  v.outcome = m.outcome;
  v.score = std::isfinite(m.score) ? static_cast<float>(m.score) : 0.0f;
  for (const FilterRule rule : kRules) {
    v.before[rule] = beliefView(before, rule, rule_in_use);
    v.after[rule] = beliefView(after, rule, rule_in_use);
  }
  const bool measured = m.outcome == SearchOutcome::matched || m.outcome == SearchOutcome::tracked;
  if (!measured || !std::isfinite(m.x) || !std::isfinite(m.tau) || !(m.tau > 0)) return v;
  v.px = m.px.cast<float>();
  v.x = static_cast<float>(m.x);
  v.tau = static_cast<float>(m.tau);
  // A float holds any divergence but infinity.
  constexpr double kMost = 1e30;
  const Belief& q = before.belief;
  const double tau2 = m.tau * m.tau;
  const Agreement a = agreement(q.mu, q.sigma2, m.x, tau2);
  v.kl_belief_measurement =
      static_cast<float>(std::min(kMost, klGaussian(q.mu, q.sigma2, m.x, tau2)));
  v.kl_measurement_belief =
      static_cast<float>(std::min(kMost, klGaussian(m.x, tau2, q.mu, q.sigma2)));
  v.jsd = static_cast<float>(a.jsd);
  v.affinity = static_cast<float>(a.affinity);
  return v;
}

}  // namespace svoscope
