// SPDX-License-Identifier: MIT
#include "engine/mapping/seed_life.h"

#include <cmath>

#include "engine/mapping/seed_update.h"

namespace svoscope {

namespace {

SeedEnding endingOf(const Belief* beliefs, std::size_t count, const DepthFilterParameters& p) {
  const Belief* last = beliefs + count;
  const auto finite = [](const Belief& q) {
    return std::isfinite(q.mu) && std::isfinite(q.sigma2);
  };
  if (!std::all_of(beliefs, last, finite)) return SeedEnding::not_finite;
  if (std::any_of(beliefs, last, [](const Belief& q) { return q.mu <= 0; }))
    return SeedEnding::no_depth;
  return beliefs->inlierRatio() < p.reject_inlier_ratio ? SeedEnding::inlier_ratio
                                                        : SeedEnding::none;
}

}  // namespace

void endSeed(SeedLife& seed, SeedEnding ending) {
  if (seed.ending != SeedEnding::none) return;
  seed.status = ending == SeedEnding::promoted ? SeedStatus::promoted : SeedStatus::rejected;
  seed.ending = ending;
}

Evidence noteSearch(SeedLife& seed, SearchOutcome outcome, int frame_index) {
  if (seed.ending != SeedEnding::none) return Evidence::none;
  seed.outcome = outcome;
  if (outcome == SearchOutcome::no_match) {
    ++seed.failures;
    return Evidence::missed;
  }
  if (outcome != SearchOutcome::matched && outcome != SearchOutcome::tracked) return Evidence::none;
  ++seed.updates;
  seed.last_frame = frame_index;
  return Evidence::measured;
}

void judge(SeedLife& seed, const Belief* beliefs, std::size_t count,
           const DepthFilterParameters& p) {
  const SeedEnding ending = endingOf(beliefs, count, p);
  const double bound = seed.range * p.converged_fraction;
  if (ending != SeedEnding::none) {
    endSeed(seed, ending);
  } else if (beliefs->inlierRatio() > p.min_inlier_ratio &&
             std::all_of(beliefs, beliefs + count,
                         [&](const Belief& q) { return std::sqrt(q.sigma2) < bound; })) {
    seed.status = SeedStatus::converged;
  }
}

}  // namespace svoscope
