// SPDX-License-Identifier: MIT
// Densities as curves to draw. Degenerate parameters give empty curves.
#pragma once

#include <vector>

#include "engine/snapshot/snapshot.h"
#include "ui/widgets/plot_math.h"

namespace svoscope::ui {

struct Curve {
  std::vector<float> x, y;
  float peak() const;  ///< 0 if empty
};

double gaussianDensity(double x, double mu, double sigma);
/// N(mu, sigma^2) over a range; dense where it is steep.
Curve gaussianCurve(double mu, double sigma, Range over);
/// The same belief about z, as a density of the distance 1 / z.
Curve gaussianAsDistance(double mu, double sigma, Range over);
/// Beta(a, b) on [0, 1].
Curve betaCurve(double a, double b);

/// Median and quantiles of unsorted values, which are reordered; NaN if none.
double quantileOf(std::vector<float>& values, double q);

}  // namespace svoscope::ui
