// SPDX-License-Identifier: MIT
// The filter lab's sliders and pictures.
#pragma once

#include <imgui/imgui.h>

#include <string>
#include <vector>

#include "ui/model/ui_state.h"
#include "ui/panels/filter/lab_worker.h"

namespace svoscope::ui {

struct PanelContext;

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
