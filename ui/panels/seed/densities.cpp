// SPDX-License-Identifier: MIT
#include "ui/panels/seed/densities.h"

#include <algorithm>
#include <cmath>

namespace svoscope::ui {

namespace {

constexpr int kEven = 60, kDense = 90;  // points: evenly, and about the mode

bool sound(double mu, double sigma, Range over) {
  return std::isfinite(mu) && std::isfinite(sigma) && sigma > 0 && over.lo < over.hi &&
         std::isfinite(over.lo) && std::isfinite(over.hi);
}

std::vector<double> nodes(double center, double spread, Range over) {
  std::vector<double> x;
  for (int i = 0; i <= kEven; ++i) x.push_back(over.lo + over.span() * i / kEven);
  for (int i = 0; i <= kDense; ++i) {
    const double at = center + spread * 5 * (2.0 * i / kDense - 1);
    if (over.contains(at)) x.push_back(at);
  }
  std::sort(x.begin(), x.end());
  return x;
}

}  // namespace

float Curve::peak() const {
  float top = 0;
  for (const float v : y) top = std::isfinite(v) ? std::max(top, v) : top;
  return top;
}

double gaussianDensity(double x, double mu, double sigma) {
  const double d = (x - mu) / sigma;
  return std::exp(-0.5 * d * d) / (sigma * 2.5066282746310002);
}

Curve gaussianCurve(double mu, double sigma, Range over) {
  Curve c;
  if (!sound(mu, sigma, over)) return c;
  for (const double x : nodes(mu, sigma, over)) {
    c.x.push_back(static_cast<float>(x));
    c.y.push_back(static_cast<float>(gaussianDensity(x, mu, sigma)));
  }
  return c;
}

Curve gaussianAsDistance(double mu, double sigma, Range over) {
  Curve c;
  if (!sound(mu, sigma, over) || over.lo <= 0) return c;
  const double center = mu > 0 ? 1 / mu : over.hi;
  const double spread = mu > 0 ? sigma / (mu * mu) : over.span();
  for (const double d : nodes(center, spread, over)) {
    c.x.push_back(static_cast<float>(d));
    c.y.push_back(static_cast<float>(gaussianDensity(1 / d, mu, sigma) / (d * d)));
  }
  return c;
}

Curve betaCurve(double a, double b) {
  Curve c;
  if (!(a > 0) || !(b > 0) || !std::isfinite(a + b)) return c;
  const double mean = a / (a + b), sd = std::sqrt(mean * (1 - mean) / (a + b + 1));
  const double log_norm = std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b);
  for (const double x : nodes(mean, sd, {1e-4, 1 - 1e-4})) {
    const double y = std::exp(log_norm + (a - 1) * std::log(x) + (b - 1) * std::log1p(-x));
    c.x.push_back(static_cast<float>(x));
    c.y.push_back(static_cast<float>(y));
  }
  return c;
}

double quantileOf(std::vector<float>& values, double q) {
  values.erase(
      std::remove_if(values.begin(), values.end(), [](float v) { return !std::isfinite(v); }),
      values.end());
  if (values.empty()) return NAN;
  const auto at = static_cast<std::ptrdiff_t>(q * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

}  // namespace svoscope::ui
