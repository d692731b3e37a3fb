// SPDX-License-Identifier: MIT
// Runs the engine until a condition holds, with a threaded or a synchronous runner alike.
#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/runner/runner.h"

namespace svoscope::ui {

/// Processes `frames` frames; fails if the sequence ends before.
Status stepFrames(Runner& runner, int frames);

/// `until` is keyframe, lost, start or a frame number. Fails if that does not happen.
Status runUntil(Runner& runner, const std::string& until);

/// Waits until a reset took effect.
Status resetRun(Runner& runner);

}  // namespace svoscope::ui
