// SPDX-License-Identifier: MIT
#include "engine/mapping/depth_filter.h"

#include <cmath>

namespace svoscope {

namespace {
constexpr double kSqrtTwoPi = 2.5066282746310002;

bool valid(const Belief& q) {
  return std::isfinite(q.mu) && std::isfinite(q.sigma2) && q.sigma2 > 0 && std::isfinite(q.a) &&
         std::isfinite(q.b) && q.a > 0 && q.b > 0;
}
}  // namespace

Belief momentMatch(const Belief& q, const Measurement& m, double weight) {
  if (!std::isfinite(m.x) || !std::isfinite(m.tau2) || m.tau2 <= 0 || !(m.range > 0)) return q;
  const double s2 = 1.0 / (1.0 / q.sigma2 + 1.0 / m.tau2);
  const double mean = s2 * (q.mu / q.sigma2 + m.x / m.tau2);
  const double variance = q.sigma2 + m.tau2;
  const double offset = m.x - q.mu;
  const double density =
      std::exp(-0.5 * offset * offset / variance) / (kSqrtTwoPi * std::sqrt(variance));
  const double ab = q.a + q.b;
  double c1 = weight * q.a / ab * density;
  double c2 = q.b / ab / m.range;
  const double total = c1 + c2;
  if (!(total > 0) || !std::isfinite(total)) return q;
  c1 /= total;
  c2 /= total;
  const double f = c1 * (q.a + 1) / (ab + 1) + c2 * q.a / (ab + 1);
  const double e = (c1 * (q.a + 1) * (q.a + 2) + c2 * q.a * (q.a + 1)) / ((ab + 1) * (ab + 2));
  Belief next;
  next.mu = c1 * mean + c2 * q.mu;
  // E[z^2] - E[z]^2 written about the new mean: no cancellation when sigma is small.
  const double d1 = mean - next.mu, d2 = q.mu - next.mu;
  next.sigma2 = c1 * (s2 + d1 * d1) + c2 * (q.sigma2 + d2 * d2);
  next.a = (e - f) / (f - e / f);
  next.b = next.a * (1 - f) / f;
  return valid(next) ? next : q;
}

}  // namespace svoscope
