// SPDX-License-Identifier: MIT
#include "ui/panels/filter/lab_view.h"

#include <algorithm>
#include <cmath>

#include "ui/widgets/controls.h"

namespace svoscope::ui {

void SeparationCurves::update(float sigma_now, float tau_now) {
  if (sigma_now == sigma && tau_now == tau) return;
  *this = SeparationCurves();
  sigma = sigma_now;
  tau = tau_now;
  constexpr int kPoints = 121;
  const double reach = 6 * std::hypot(sigma_now, tau_now);
  for (int i = 0; i < kPoints; ++i) {
    const double at = reach * i / (kPoints - 1);
    const LabPair pair = comparePair(0, sigma_now, at, tau_now);
    offset.push_back(static_cast<float>(at));
    kl_pq.push_back(static_cast<float>(pair.kl_pq));
    kl_qp.push_back(static_cast<float>(pair.kl_qp));
    jsd.push_back(static_cast<float>(pair.jsd));
  }
}

// The point lies straight ahead of the first camera, the second stands beside it: paper, Figure 2.
// Law of sines on (first, second, point) with the second ray turned by the noise.
TwoViews twoViews(double baseline, double depth, double pixel_noise, double focal) {
  TwoViews v;
  const double turn = std::atan(pixel_noise / focal);
  const double at_second = std::atan2(depth, baseline);  // angle between baseline and second ray
  v.angle = std::atan2(baseline, depth);
  const auto along = [&](double angle) {
    return angle < M_PI_2 ? baseline * std::tan(angle) : INFINITY;
  };
  v.near_m = along(at_second - turn);
  v.far_m = along(at_second + turn);
  const double far_inverse = std::isfinite(v.far_m) ? 1 / v.far_m : 0;
  v.tau = v.near_m > 0 ? (1 / v.near_m - far_inverse) / 2 : INFINITY;
  return v;
}

LabOptions labOptions(const LabSettings& s) {
  LabOptions o;
  o.seeds = std::max(60, static_cast<int>(s.seeds));
  o.outliers = s.outliers;
  o.hopeless = s.hopeless;
  o.noise = s.noise;
  o.step_m = s.step_m;
  return o;
}

std::string labCsv(const LabSettings& s, const SeparationCurves& curves, const LabResult* result) {
  std::string text = format("# sigma %g, tau %g\nseparation,kl_pq,kl_qp,jsd\n", s.sigma, s.tau);
  for (std::size_t i = 0; i < curves.offset.size(); ++i) {
    text += format("%g,%.9g,%.9g,%.9g\n", curves.offset[i], curves.kl_pq[i], curves.kl_qp[i],
                   curves.jsd[i]);
  }
  if (!result) return text;
  text += format("# %d seeds, outliers %g, hopeless %g, noise %g, step %g m\n",
                 result->options.seeds, result->options.outliers, result->options.hopeless,
                 result->options.noise, result->options.step_m);
  text += "rule,update,converged,median_error_per_m,median_sigma_per_m\n";
  for (const LabRow& row : result->rows) {
    for (const LabCurvePoint& p : row.curve) {
      text += format("%s,%d,%.6g,%.9g,%.9g\n", row.rule.c_str(), p.update, p.converged,
                     p.median_error, p.median_sigma);
    }
  }
  text += "rule,gate,recall,wrong\n";
  for (const LabRow& row : result->rows) {
    for (const GatePoint& p : row.sweep)
      text += format("%s,%.6g,%.6g,%.6g\n", row.rule.c_str(), p.gate, p.recall, p.wrong);
  }
  return text;
}

}  // namespace svoscope::ui
