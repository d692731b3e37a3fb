// SPDX-License-Identifier: MIT
// The bars below every layout; they are no panels of it.
#pragma once

namespace svoscope::ui {

struct PanelContext;

void drawTransportBar(PanelContext& context);
void drawStatusBar(PanelContext& context);

}  // namespace svoscope::ui
