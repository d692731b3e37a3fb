// SPDX-License-Identifier: MIT
#include "engine/study/lab.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "engine/base/quantile.h"
#include "engine/mapping/divergence.h"
#include "engine/study/rule_variants.h"

namespace svoscope {

namespace {

constexpr int kBaselineFrames = 40;  // the baseline grows for so many frames
constexpr double kLeastInverseDepth = 1e-3;
constexpr double kMissedSilent = 0.7;  // a truth outside the window gives no match so often

struct SimulatedSeed {
  double depth = 1;
  bool hopeless = false;
  Belief belief;
  int converged_at = 0;  // 0: not yet

  double error() const { return belief.mu - 1 / depth; }
  double relativeError() const { return std::abs(1 / belief.mu - depth) / depth; }
};

class Simulation {
 public:
  Simulation(const LabOptions& o, const RuleVariant& rule)
      : o_(o), rule_(rule), random_(o.random_seed), range_(1 / o.min_depth_m) {
    seeds_.resize(static_cast<std::size_t>(o.seeds));
    for (SimulatedSeed& s : seeds_) {
      s.depth = o.min_depth_m + (2 * o.mean_depth_m - 2 * o.min_depth_m) * uniform_(random_);
      s.hopeless = uniform_(random_) < o.hopeless;
      s.belief = {1 / o.mean_depth_m, range_ * range_ / 36, 10, 10};
    }
  }

  LabRow run() {
    LabRow row;
    row.rule = rule_.name;
    for (int t = 1; t <= o_.updates; ++t) {
      for (SimulatedSeed& s : seeds_) measure(s, t);
      row.curve.push_back(curvePoint(t));
    }
    judge(row);
    return row;
  }

 private:
  /// All random numbers are drawn whatever happens, so that every rule sees the same ones.
  void measure(SimulatedSeed& s, int t) {
    const double tau = 1 / (o_.focal_px * o_.step_m * std::min(t, kBaselineFrames));
    const double gauss = normal_(random_), out_draw = uniform_(random_), place = uniform_(random_),
                 silent = uniform_(random_);
    if (s.converged_at > 0) return;
    const double half = std::max(o_.search_sigmas * std::sqrt(s.belief.sigma2), 2 * tau);
    const double low = std::max(s.belief.mu - half, kLeastInverseDepth),
                 high = std::max(s.belief.mu + half, low);
    const bool outlier = out_draw < o_.outliers;
    const bool missed = !outlier && !s.hopeless && (1 / s.depth < low || 1 / s.depth > high);
    if (missed && silent < kMissedSilent) {
      s.belief.b += 1;
    } else {
      const bool stray = outlier || missed || s.hopeless;
      const double x = stray ? low + (high - low) * place : 1 / s.depth + o_.noise * tau * gauss;
      s.belief = updateBelief(rule_.rule, s.belief, {x, tau * tau, range_}, rule_.settings);
    }
    if (std::sqrt(s.belief.sigma2) < range_ * o_.converged_fraction) s.converged_at = t;
  }

  LabCurvePoint curvePoint(int t) const {
    std::vector<double> errors, sigmas;
    int converged = 0;
    for (const SimulatedSeed& s : seeds_) {
      if (s.hopeless) continue;
      errors.push_back(std::abs(s.error()));
      sigmas.push_back(std::sqrt(s.belief.sigma2));
      converged += s.converged_at > 0;
    }
    const double n = std::max<double>(1, static_cast<double>(errors.size()));
    return {t, interpolatedQuantile(std::move(errors), 0.5).value_or(0),
            interpolatedQuantile(std::move(sigmas), 0.5).value_or(0), converged / n};
  }

  void judge(LabRow& row) const {
    std::vector<SeedVerdict> verdicts;
    std::vector<double> updates, right_errors, errors, nees;
    int converged = 0, hopeless = 0, hopeless_converged = 0;
    for (const SimulatedSeed& s : seeds_) {
      const bool done = s.converged_at > 0;
      const bool right = done && !s.hopeless && s.relativeError() < o_.right_error;
      verdicts.push_back({!s.hopeless, done, right, s.belief.inlierRatio()});
      converged += done;
      hopeless += s.hopeless;
      hopeless_converged += s.hopeless && done;
      if (done && !s.hopeless) errors.push_back(s.relativeError());
      if (!right) continue;
      updates.push_back(s.converged_at);
      right_errors.push_back(s.relativeError());
      nees.push_back(s.error() * s.error() / s.belief.sigma2);
    }
    row.median_updates = interpolatedQuantile(std::move(updates), 0.5);
    row.median_relative_error = interpolatedQuantile(std::move(right_errors), 0.5);
    row.p90_relative_error = interpolatedQuantile(std::move(errors), 0.9);
    row.median_nees = interpolatedQuantile(std::move(nees), 0.5);
    row.wrong_at_80 = wrongAtRecall(verdicts, 0.8);
    row.wrong_at_60 = wrongAtRecall(verdicts, 0.6);
    row.converged = static_cast<double>(converged) / std::max(1, o_.seeds);
    row.hopeless_converged = static_cast<double>(hopeless_converged) / std::max(1, hopeless);
    row.sweep = sweepGate(verdicts);
  }

  const LabOptions& o_;
  const RuleVariant& rule_;
  std::mt19937_64 random_;
  std::uniform_real_distribution<double> uniform_{0, 1};
  std::normal_distribution<double> normal_;
  double range_;
  std::vector<SimulatedSeed> seeds_;
};

}  // namespace

std::string LabOptions::check() const {
  const auto fraction = [](double v) { return v >= 0 && v <= 1; };
  if (seeds < 1 || seeds > 1000000) return "seeds: 1 to 1000000";
  if (updates < 1 || updates > 10000) return "updates: 1 to 10000";
  if (!fraction(outliers)) return "outliers: 0 to 1";
  if (!fraction(hopeless)) return "hopeless: 0 to 1";
  if (!(noise >= 0 && noise <= 100)) return "noise: 0 to 100 tau";
  if (!(search_sigmas > 0 && search_sigmas <= 100)) return "search sigmas: above 0, up to 100";
  if (!(step_m > 0 && step_m <= 100)) return "baseline step: above 0, up to 100 m";
  if (!(focal_px > 0 && focal_px <= 1e6)) return "focal length: above 0, up to 1000000 px";
  if (!(min_depth_m > 0 && mean_depth_m >= min_depth_m && mean_depth_m < 1e6))
    return "depths: 0 < min <= mean";
  if (!(converged_fraction > 0 && converged_fraction < 1))
    return "converged fraction: between 0 and 1";
  if (!(right_error > 0)) return "right error: above 0";
  return {};
}

LabResult runLab(const LabOptions& options) {
  LabResult result;
  result.options = options;
  if (!options.check().empty()) return result;
  for (const RuleVariant& rule : ruleVariants())
    result.rows.push_back(Simulation(options, rule).run());
  return result;
}

LabPair comparePair(double mean_p, double sigma_p, double mean_q, double sigma_q) {
  const double vp = sigma_p * sigma_p, vq = sigma_q * sigma_q;
  const Agreement a = agreement(mean_p, vp, mean_q, vq);
  return {klGaussian(mean_p, vp, mean_q, vq), klGaussian(mean_q, vq, mean_p, vp), a.jsd,
          a.affinity};
}

}  // namespace svoscope
