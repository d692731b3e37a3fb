// SPDX-License-Identifier: MIT
// The rule of SVO and PL-SVO.
#include "engine/mapping/depth_filter.h"

namespace svoscope {

Belief rules::kl(const Belief& q, const Measurement& m, const RuleSettings&) {
  return momentMatch(q, m, 1.0);
}

}  // namespace svoscope
