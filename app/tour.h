// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "engine/base/result.h"
#include "engine/snapshot/snapshot.h"

namespace svoscope {

/// Writes tour.script into `folder` (made if absent): the main screens of the inspector, for use
/// without a display. Returns its path.
Result<std::filesystem::path> writeTour(const std::filesystem::path& folder, const RunInfo& info,
                                        bool several);

}  // namespace svoscope
