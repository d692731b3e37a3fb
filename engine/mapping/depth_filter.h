// SPDX-License-Identifier: MIT
// The Gaussian x Beta depth filter (Vogiatzis & Hernandez, IVC 2011) on inverse distance: one
// measurement updates the belief q(z, rho) = N(z | mu, sigma^2) Beta(rho | a, b). docs/method.md.
#pragma once

namespace svoscope {

/// Belief of a seed. Inverse distance in 1/map unit.
struct Belief {
  double mu = 1;
  double sigma2 = 1;   ///< variance, (1/map unit)^2
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

/// The rule of SVO and PL-SVO.
inline Belief updateKl(const Belief& belief, const Measurement& m) { return momentMatch(belief, m, 1.0); }

}  // namespace svoscope
