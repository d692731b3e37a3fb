// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "ui/panels/panel_context.h"

namespace svoscope::ui {

/// Frames of the longest open run: a recording may hold fewer than the sequence has.
inline int frameCount(const PanelContext& context) {
  int frames = context.info.frames;
  for (int i = 0; i < context.runs.size(); ++i) {
    frames = std::max(frames, context.runs.run(i).info().frames);
  }
  return frames;
}

}  // namespace svoscope::ui
