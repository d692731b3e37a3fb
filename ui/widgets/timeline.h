// SPDX-License-Identifier: MIT
// All frames of a run on one strip: states, keyframes, events, tracking time, what is still held.
#pragma once

#include <imgui/imgui.h>

#include <optional>
#include <vector>

#include "engine/snapshot/snapshot.h"

namespace svoscope::ui {

struct TimelineSpec {
  const std::vector<FrameRecord>* records = nullptr;
  const std::vector<Event>* events = nullptr;
  int frames = 0;         ///< of the sequence
  int history_first = 0;  ///< oldest frame still held
  int viewed = -1;        ///< frame shown
  int engine = -1;        ///< last frame processed
  double budget_ms = 0;   ///< a frame's time at the sequence's rate
  float height = 0;
};

/// Frame to view if the user clicked or dragged.
std::optional<int> timeline(const char* label, const TimelineSpec& spec);

/// Frame under a pixel of a strip from lo to hi that shows `frames` frames.
int frameAtPixel(float x, float lo, float hi, int frames);

}  // namespace svoscope::ui
