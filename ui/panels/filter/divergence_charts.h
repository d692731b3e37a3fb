// SPDX-License-Identifier: MIT
#pragma once

#include "ui/panels/filter/divergence_view.h"

namespace svoscope::ui {

/// All pictures of the KL / JS panel, laid out over the room there is.
void divergenceCharts(PanelContext& c, const DivergenceView& view);

}  // namespace svoscope::ui
