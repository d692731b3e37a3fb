// SPDX-License-Identifier: MIT
#include "engine/study/depth_study_judge.h"

#include <algorithm>
#include <cmath>

#include "engine/base/quantile.h"

namespace svoscope {

namespace {

constexpr double kOutlierTaus = 3, kOutlierError = 0.05;
constexpr double kChi2Of95 = 3.841;

double relativeError(const StudySeed& s) { return std::abs(s.true_inverse / s.seed.belief.mu - 1); }

double nees(const StudySeed& s) {
  const double error = s.seed.belief.mu - s.true_inverse;
  return error * error / s.seed.belief.sigma2;
}

std::vector<double> convergedByAge(const std::vector<StudySeed>& seeds, int max_age) {
  std::vector<double> share(static_cast<std::size_t>(max_age) + 1, 0.0);
  for (const StudySeed& s : seeds) {
    if (s.converged_after > 0 && s.converged_age <= max_age)
      share[static_cast<std::size_t>(s.converged_age)] += 1;
  }
  double sum = 0;
  for (double& v : share) {
    sum += v;
    v = sum / static_cast<double>(seeds.size());
  }
  return share;
}

void judgeMeasurements(const std::vector<StudySeed>& seeds, DepthStudyRow& row) {
  std::vector<double> all;
  int outliers = 0;
  for (const StudySeed& s : seeds) {
    row.failures += s.seed.failures;
    outliers += s.outliers;
    all.insert(all.end(), s.measurement_nees.begin(), s.measurement_nees.end());
  }
  row.measurements = static_cast<int>(all.size());
  if (row.measurements > 0) row.outlier_share = static_cast<double>(outliers) / row.measurements;
  row.median_measurement_nees = interpolatedQuantile(std::move(all), 0.5);
}

void judgeAccepted(std::vector<double> accepted_nees, DepthStudyRow& row) {
  for (const double q : kErrorQuantiles)
    row.error_quantiles.push_back(interpolatedQuantile(row.errors, q));
  std::sort(row.errors.begin(), row.errors.end());
  std::sort(row.normalised_errors.begin(), row.normalised_errors.end());
  if (!accepted_nees.empty()) {
    const auto inside = std::count_if(accepted_nees.begin(), accepted_nees.end(),
                                      [](double v) { return v < kChi2Of95; });
    row.nees_inside_95 = static_cast<double>(inside) / static_cast<double>(accepted_nees.size());
  }
  row.median_nees = interpolatedQuantile(std::move(accepted_nees), 0.5);
}

}  // namespace

void StudySeed::apply(const SeedMeasurement& m, const DepthFilterParameters& p) {
  applyMeasurement(seed, m, p);
  if (m.outcome != SearchOutcome::matched) return;
  const double off = m.x - true_inverse;
  measurement_nees.push_back(static_cast<float>(off * off / (m.tau * m.tau)));
  outliers += std::abs(off) > kOutlierTaus * m.tau && std::abs(off) > kOutlierError * true_inverse;
  if (seed.ending != SeedEnding::none ||
      std::sqrt(seed.belief.sigma2) >= seed.range * p.converged_fraction)
    return;
  converged_after = seed.updates;
  converged_age = m.frame_index - born;
}

DepthStudyRow judgeSeeds(const std::string& rule, const std::vector<StudySeed>& seeds,
                         const DepthFilterParameters& filter, const DepthStudyOptions& o) {
  DepthStudyRow row;
  row.rule = rule;
  row.seeds = static_cast<int>(seeds.size());
  std::vector<SeedVerdict> verdicts;
  std::vector<double> updates, accepted_nees;
  for (const StudySeed& s : seeds) {
    const bool converged = s.converged_after > 0;
    const bool right = converged && relativeError(s) < o.right_error;
    const double ratio = s.seed.belief.inlierRatio();
    verdicts.push_back({true, converged, right, ratio});
    row.converged += converged;
    row.rejected += !converged && s.seed.ending != SeedEnding::none;
    row.unfinished += !converged && s.seed.ending == SeedEnding::none;
    if (converged) updates.push_back(s.converged_after);
    if (!converged || ratio <= filter.min_inlier_ratio) continue;
    ++row.accepted;
    row.accepted_wrong += !right;
    row.errors.push_back(relativeError(s));
    accepted_nees.push_back(nees(s));
    row.normalised_errors.push_back(std::sqrt(nees(s)));
  }
  row.recall = static_cast<double>(row.accepted - row.accepted_wrong) / std::max(1, row.seeds);
  row.median_updates = interpolatedQuantile(std::move(updates), 0.5);
  row.sweep = sweepGate(verdicts);
  row.wrong_at_80 = wrongAtRecall(verdicts, 0.8);
  row.wrong_at_60 = wrongAtRecall(verdicts, 0.6);
  row.wrong_at_40 = wrongAtRecall(verdicts, 0.4);
  row.converged_by_age = convergedByAge(seeds, o.max_age);
  judgeMeasurements(seeds, row);
  judgeAccepted(std::move(accepted_nees), row);
  return row;
}

}  // namespace svoscope
