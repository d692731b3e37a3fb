// SPDX-License-Identifier: MIT
// The filter lab's sliders and pictures.
#pragma once

#include <imgui/imgui.h>

#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "ui/panels/filter/lab_worker.h"

namespace svoscope::ui {

struct PanelContext;

/// What the sliders stand at.
struct LabSettings {
  float mu = 1, sigma = 0.25f, offset = 0.6f, tau = 0.15f;  ///< two Gaussians; offset = x - mu
  float baseline = 0.15f, depth = 2.5f, pixel_noise = 4, focal = 525;  ///< two views: m, m, px, px
  float outliers = 0.2f, hopeless = 0.2f, noise = 0.4f, step_m = 0.01f, seeds = 2000;
};

struct LabChoices {
  int section = 0;    ///< divergences, two views, population, all
  bool wait = false;  ///< hold the window until the population is simulated; for scripts
  std::uint64_t random_seed = 0;
};

/// The population that is simulated, and what its worker was started with.
struct LabSimulation {
  LabWorker worker;
  std::tuple<int, double, double, double, double, std::uint64_t> started;
};

/// Divergences over the separation, for the spreads at hand.
struct SeparationCurves {
  float sigma = -1, tau = -1;
  std::vector<float> offset, kl_pq, kl_qp, jsd;
  void update(float sigma_now, float tau_now);
};

/// Two views of a point with a match that may be off by the noise.
struct TwoViews {
  double angle = 0;              ///< between the rays, radians
  double near_m = 0, far_m = 0;  ///< ends of the interval; far_m infinite beyond the horizon
  double tau = 0;                ///< of the inverse distance, 1/m: half of the interval
};
TwoViews twoViews(double baseline, double depth, double pixel_noise, double focal);

LabOptions labOptions(const LabSettings& settings);

void divergenceSection(PanelContext& c, ImVec2 size);
void twoViewSection(PanelContext& c, ImVec2 size);
void populationSection(PanelContext& c, ImVec2 size);

std::string labCsv(const LabSettings& settings, const SeparationCurves& curves,
                   const LabResult* result);

}  // namespace svoscope::ui
