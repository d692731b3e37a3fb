// SPDX-License-Identifier: MIT
// What the Compare panels share.
#pragma once

#include "ui/panels/compare/compare_data.h"
#include "ui/panels/panel_context.h"
#include "ui/widgets/controls.h"

namespace svoscope::ui {

/// Brings the comparison up to date. False, with a message in the panel, if only one run is open.
bool comparing(PanelContext& context);
/// The same without a message; false also before the first frame.
bool updateComparison(PanelContext& context);

Swatch swatchOf(Dash dash);

/// Swatch, name, and what the run does in the viewed frame.
void runTitle(PanelContext& context, const RunStyle& style, const FrameRecord* record);
/// "Lost: 31 inliers < 40 required"
std::string runStateText(const RunStyle& style, const FrameRecord* record);

}  // namespace svoscope::ui
