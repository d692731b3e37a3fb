// SPDX-License-Identifier: MIT
#include "engine/study/gate_sweep.h"

#include <algorithm>
#include <cmath>

namespace svoscope {

std::vector<GatePoint> sweepGate(const std::vector<SeedVerdict>& seeds) {
  std::vector<const SeedVerdict*> converged;
  int possible = 0;
  for (const SeedVerdict& s : seeds) {
    possible += s.possible;
    if (s.converged) converged.push_back(&s);
  }
  std::vector<GatePoint> points;
  if (possible == 0) return points;
  std::stable_sort(converged.begin(), converged.end(),
                   [](const auto* a, const auto* b) { return a->inlier_ratio > b->inlier_ratio; });
  int accepted = 0, right = 0;
  for (std::size_t i = 0; i < converged.size();) {
    const double gate = converged[i]->inlier_ratio;
    const int right_before = right;
    for (; i < converged.size() && converged[i]->inlier_ratio == gate; ++i) {
      ++accepted;
      right += converged[i]->right;
    }
    if (right == right_before) continue;
    points.push_back(
        {gate, static_cast<double>(right) / possible, 1 - static_cast<double>(right) / accepted});
  }
  return points;
}

std::optional<double> wrongAtRecall(const std::vector<SeedVerdict>& seeds, double recall) {
  for (const GatePoint& p : sweepGate(seeds)) {
    if (p.recall >= recall) return p.wrong;
  }
  return std::nullopt;
}

}  // namespace svoscope
