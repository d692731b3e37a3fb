// SPDX-License-Identifier: MIT
#pragma once

#include "engine/mapping/depth_filter.h"
#include "engine/mapping/divergence.h"

namespace svoscope {

/// The JS rule with an agreement of belief and measurement known already.
Belief updateJs(const Belief& belief, const Measurement& m, const JsSwitches& switches,
                const Agreement& agreement);

}  // namespace svoscope
