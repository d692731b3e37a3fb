// SPDX-License-Identifier: MIT
#include "ui/panels/filter/filter_stats.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>
#include <utility>

#include "ui/model/seed_trace.h"
#include "ui/panels/seed/densities.h"
#include "ui/widgets/controls.h"

namespace svoscope::ui {

void Bins::add(double value) {
  if (std::isnan(value)) return;
  const double v = log_ ? std::log10(std::max(value, 1e-300)) : value;
  const double lo = log_ ? std::log10(lo_) : lo_, hi = log_ ? std::log10(hi_) : hi_;
  const auto n = static_cast<double>(counts_.size());
  const double at = std::clamp((v - lo) / (hi - lo) * n, 0.0, n - 1);
  ++counts_[static_cast<std::size_t>(at)];
  ++total_;
}

void Bins::clear() {
  std::fill(counts_.begin(), counts_.end(), 0);
  total_ = 0;
}

double Bins::edge(int i) const {
  const double t = static_cast<double>(i) / static_cast<double>(counts_.size());
  return log_ ? lo_ * std::pow(hi_ / lo_, t) : lo_ + t * (hi_ - lo_);
}

double Bins::quantile(double q) const {
  if (total_ == 0) return NAN;
  const double wanted = q * total_;
  double sum = 0;
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    if (counts_[i] == 0 || sum + counts_[i] < wanted) {
      sum += counts_[i];
      continue;
    }
    const double f = (wanted - sum) / counts_[i],
                 t = (static_cast<double>(i) + f) / static_cast<double>(counts_.size());
    return log_ ? lo_ * std::pow(hi_ / lo_, t) : lo_ + t * (hi_ - lo_);
  }
  return hi_;
}

namespace {
template <std::size_t... I>
ByRule<Bins> sameForAll(const Bins& bins, std::index_sequence<I...>) {
  return {{((void)I, bins)...}};
}
}  // namespace

FilterDistributions::FilterDistributions()
    : kl(1e-3, 1e4, 56, true),
      kl_reverse(1e-3, 1e4, 56, true),
      jsd(0, 0.6931472, 40, false),
      affinity(0, 1, 40, false),
      sigma_ratio(0.25, 4, 64, true),
      ratio(sameForAll(Bins(0, 1, 50, false), std::make_index_sequence<kRuleCount>())) {}

void FilterDistributions::add(const UpdatePoint& p) {
  kl.add(p.kl);
  kl_reverse.add(p.kl_reverse);
  jsd.add(p.jsd);
  affinity.add(p.affinity);
  const float first = p.sigma[kRules[0]], second = p.sigma[kRules[1]];
  if (first > 0 && second > 0) sigma_ratio.add(second / first);
  for (const FilterRule rule : kRules) {
    if (p.sigma[rule] > 0) ratio[rule].add(p.ratio[rule]);
  }
}

void FilterDistributions::clear() {
  for (Bins* b : {&kl, &kl_reverse, &jsd, &affinity, &sigma_ratio}) b->clear();
  for (Bins& b : ratio) b.clear();
}

namespace {

UpdatePoint pointOf(const SeedUpdateView& u, const SeedView* seed, int frame) {
  UpdatePoint p;
  p.seed_id = u.seed_id;
  p.frame = frame;
  p.kl = u.kl_belief_measurement;
  p.kl_reverse = u.kl_measurement_belief;
  p.jsd = u.jsd;
  p.affinity = u.affinity;
  for (const FilterRule rule : kRules) {
    const BeliefView& after = u.after[rule];
    p.mu[rule] = after.mu;
    p.sigma[rule] = drawable(after) ? after.sigma : 0;
    p.ratio[rule] = static_cast<float>(inlierRatio(after));
  }
  if (seed) p.true_inv_distance = seed->true_inv_distance;
  return p;
}

bool measured(const SeedUpdateView& u) {
  return std::isfinite(u.x) && std::isfinite(u.tau) && u.tau > 0;
}

using SeedIndex = std::unordered_map<std::int64_t, const SeedView*>;

SeedIndex indexSeeds(const Snapshot& s) {
  SeedIndex index;
  if (!s.seeds) return index;
  index.reserve(s.seeds->size());
  for (const SeedView& seed : *s.seeds) index[seed.id] = &seed;
  return index;
}

template <typename Use>
void forMeasurements(const Snapshot& s, const Use& use) {
  if (!s.seed_updates) return;
  const SeedIndex index = indexSeeds(s);
  for (const SeedUpdateView& u : *s.seed_updates) {
    if (!measured(u)) continue;
    const auto it = index.find(u.seed_id);
    use(u, it == index.end() ? nullptr : it->second);
  }
}

}  // namespace

std::vector<UpdatePoint> pointsOf(const Snapshot& s) {
  std::vector<UpdatePoint> points;
  forMeasurements(s, [&](const SeedUpdateView& u, const SeedView* seed) {
    points.push_back(pointOf(u, seed, s.record.index));
  });
  return points;
}

bool FilterStats::update(const RunView& run, const SnapshotPtr& latest) {
  if (run.generation() != generation_) {
    const std::uint64_t version = version_ + 1;
    *this = FilterStats();
    version_ = version;
    generation_ = run.generation();
  }
  if (!latest) return true;
  next_ = std::max(next_, run.status().history_first);
  for (int n = 0; next_ <= latest->record.index; ++next_) {
    if (n++ >= kSnapshotsPerCall) return false;
    if (const SnapshotPtr s = run.valuesAt(next_)) read(*s);
  }
  return true;
}

void FilterStats::read(const Snapshot& s) {
  if (first_ < 0) first_ = s.record.index;
  for (auto& rule : by_updates_) {
    if (rule.empty()) rule.assign(kMostUpdates, Bins(1e-5, 1, 100, true));
  }
  forMeasurements(s, [&](const SeedUpdateView& u, const SeedView* seed) {
    const UpdatePoint p = pointOf(u, seed, s.record.index);
    run_.add(p);
    points_.push_back(p);
    if (points_.size() > kMostPoints) points_.pop_front();
    ++measurements_;
    // Several measurements of a seed in one snapshot count at its newest number of updates.
    if (!seed || seed->updates < 1 || seed->updates > kMostUpdates || !(seed->range > 0)) return;
    for (const FilterRule rule : kRules) {
      if (p.sigma[rule] > 0)
        by_updates_[rule][static_cast<std::size_t>(seed->updates) - 1].add(p.sigma[rule] /
                                                                           seed->range);
    }
  });
  ++version_;
}

std::vector<float> FilterStats::convergence(FilterRule rule, double q) const {
  std::vector<float> values;
  for (const Bins& b : by_updates_[rule]) {
    values.push_back(b.total() < 5 ? NAN : static_cast<float>(b.quantile(q)));
  }
  while (!values.empty() && std::isnan(values.back())) values.pop_back();
  return values;
}

int FilterStats::seedsWith(int updates) const {
  const auto& bins = by_updates_[kRules.front()];
  return updates >= 1 && updates <= static_cast<int>(bins.size())
             ? bins[static_cast<std::size_t>(updates) - 1].total()
             : 0;
}

std::vector<std::int64_t> brushed(const std::vector<UpdatePoint>& points, double kl_lo,
                                  double kl_hi, double jsd_lo, double jsd_hi) {
  std::set<std::int64_t> ids;
  for (const UpdatePoint& p : points) {
    if (p.kl >= kl_lo && p.kl <= kl_hi && p.jsd >= jsd_lo && p.jsd <= jsd_hi) ids.insert(p.seed_id);
  }
  return {ids.begin(), ids.end()};
}

Calibration calibrate(const std::vector<UpdatePoint>& points, double scale) {
  Calibration out;
  if (!(scale > 0)) return out;
  ByRule<std::vector<float>> z, nees;
  for (const UpdatePoint& p : points) {
    if (!(p.true_inv_distance > 0)) continue;
    const double truth = p.true_inv_distance * scale;
    ++out.count;
    for (const FilterRule r : kRules) {
      if (!(p.sigma[r] > 0) || !(p.mu[r] > 0)) continue;
      const auto sigmas = static_cast<float>(std::abs(p.mu[r] - truth) / p.sigma[r]);
      z[r].push_back(sigmas);
      nees[r].push_back(sigmas * sigmas);
      out.error[r].push_back(static_cast<float>(std::abs(truth / p.mu[r] - 1)));
    }
  }
  for (const FilterRule r : kRules) {
    std::sort(z[r].begin(), z[r].end());
    std::sort(out.error[r].begin(), out.error[r].end());
    out.median_nees[r] = quantileOf(nees[r], 0.5);
    out.median_error[r] = out.error[r].empty() ? NAN : out.error[r][out.error[r].size() / 2];
  }
  for (int i = 0; i <= 60; ++i) {
    const double k = 4.0 * i / 60;
    out.expected.push_back(static_cast<float>(std::erf(k / 1.4142135623730951)));
    for (const FilterRule r : kRules) {
      const auto below =
          std::upper_bound(z[r].begin(), z[r].end(), static_cast<float>(k)) - z[r].begin();
      out.share[r].push_back(
          z[r].empty() ? NAN : static_cast<float>(below) / static_cast<float>(z[r].size()));
    }
  }
  return out;
}

std::string statsCsv(const std::vector<UpdatePoint>& points) {
  std::string text = "seed,frame,kl_belief_measurement,kl_measurement_belief,jsd,affinity";
  for (const RuleInfo& rule : kRuleTable)
    text += format(",%s_mu,%s_sigma,%s_inlier_ratio", rule.id, rule.id, rule.id);
  text += ",true_inverse_distance_per_m\n";
  for (const UpdatePoint& p : points) {
    text += format("%lld,%d,%.9g,%.9g,%.9g,%.9g", static_cast<long long>(p.seed_id), p.frame, p.kl,
                   p.kl_reverse, p.jsd, p.affinity);
    for (const FilterRule rule : kRules)
      text += format(",%.9g,%.9g,%.6g", p.mu[rule], p.sigma[rule], p.ratio[rule]);
    text += format(",%.9g\n", p.true_inv_distance);
  }
  return text;
}

}  // namespace svoscope::ui
